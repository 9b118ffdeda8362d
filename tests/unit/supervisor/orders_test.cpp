// One supervisor that goes on from where another was.

#include <gtest/gtest.h>

#include <algorithm>

#include "supervisor/supervisor.hpp"
#include "estimates.hpp"

namespace farrier::supervisor {
namespace orders_test {

using namespace testing;
using signals::JointControllerGains;
using signals::JointModelEstimate;

constexpr std::uint64_t kSession = 31;
constexpr std::uint16_t kKnee = 2;
constexpr signals::Phase kSwing = signals::Phase::kSwing, kStance = signals::Phase::kStance;
constexpr Tick kLong = 2000;

Supervisor adaptive() { return Supervisor::create(hyq(), Design::kAdaptive, kNoDelay, kSession).value(); }

JointModelEstimate knee_estimate(const plant::LoadParams& load, signals::Phase phase) {
  return estimate_of(robot::model_of(hyq().joints[kKnee], load, hyq().period_s), kKnee, phase);
}

void mirror_all(Supervisor& standby, const Supervisor::Outputs& outputs) {
  for (const JointControllerGains& gains : outputs.gains) {
    standby.mirror(gains);
  }
  for (const signals::SystemMode& mode : outputs.modes) {
    standby.mirror(mode);
  }
}

/// Steps from `begin` on, with an estimate before each step that follows an estimate's tick; every order issued.
std::vector<JointControllerGains> issued_by(Supervisor& supervisor, Tick begin, Tick ticks,
                                            const JointModelEstimate& estimate, Supervisor* standby = nullptr) {
  std::vector<JointControllerGains> issued;
  for (Tick tick = begin; tick < begin + ticks; ++tick) {
    if (tick > 0 && hyq().estimate_due(tick - 1)) {
      supervisor.take(estimate, tick);
    }
    const Supervisor::Outputs& outputs = supervisor.step(tick);
    issued.insert(issued.end(), outputs.gains.begin(), outputs.gains.end());
    if (standby != nullptr) {
      mirror_all(*standby, outputs);
    }
  }
  return issued;
}

JointControllerGains order_of(Supervisor& supervisor, std::uint16_t joint, signals::Phase phase) {
  const auto& gains = supervisor.orders().gains;
  const auto found = std::ranges::find_if(gains, [&](const auto& g) { return g.joint == joint && g.phase == phase; });
  return found == gains.end() ? JointControllerGains{} : *found;
}

TEST(SupervisorOrders, WhoTakesOverWritesWhatActsUnderItsOwnAuthority) {
  Supervisor leader = adaptive();
  Supervisor standby = adaptive();
  const auto estimate = knee_estimate(hyq().joints[kKnee].stance_load, kStance);
  const auto issued = issued_by(leader, 0, kLong, estimate, &standby);
  ASSERT_GT(issued.size(), 2 * hyq().joints.size()) << "it redesigned the knee";
  standby.take_over(2, 1, kLong);
  EXPECT_EQ(standby.orders().gains.size(), 2 * hyq().joints.size());
  const JointControllerGains newest = issued.back();
  const JointControllerGains written = order_of(standby, newest.joint, newest.phase);
  EXPECT_EQ(written.authority, 2u);
  EXPECT_EQ(written.generation, newest.generation);
  EXPECT_EQ(written.k_force, newest.k_force);
  EXPECT_EQ(written.effective_tick, newest.effective_tick);
}

TEST(SupervisorOrders, TakingOverKeepsTheEpochOfTheModeSoThatNothingIsArmedAgain) {
  Supervisor leader = adaptive();
  Supervisor standby = adaptive();
  mirror_all(standby, leader.step(0));
  standby.take_over(2, 1, 50);
  ASSERT_EQ(standby.orders().modes.size(), 1u);
  EXPECT_EQ(standby.orders().modes[0].epoch, 1u);
  EXPECT_EQ(standby.orders().modes[0].authority, 2u);
}

TEST(SupervisorOrders, NextGainsOfWhoTookOverContinueTheGenerations) {
  Supervisor leader = adaptive();
  Supervisor standby = adaptive();
  const robot::Joint& knee = hyq().joints[kKnee];
  const auto before = issued_by(leader, 0, kLong, knee_estimate(knee.stance_load, kStance), &standby);
  standby.take_over(2, 1, kLong);
  const auto after = issued_by(standby, kLong, kLong, knee_estimate(knee.stance_load, kSwing));
  ASSERT_FALSE(after.empty());
  EXPECT_EQ(after.front().generation, before.back().generation + 1);
  EXPECT_EQ(after.front().authority, 2u);
}

TEST(SupervisorOrders, WhoMirroredGainsDoesNotDesignThemAgain) {
  Supervisor leader = adaptive();
  Supervisor standby = adaptive();
  const auto estimate = knee_estimate(hyq().joints[kKnee].stance_load, kStance);
  issued_by(leader, 0, kLong, estimate, &standby);
  standby.take_over(2, 1, kLong);
  EXPECT_TRUE(issued_by(standby, kLong, kLong, estimate).empty());
}

TEST(SupervisorOrders, WhoKnowsOfNothingWritesNothingAndLetsItAct) {
  Supervisor restarted = adaptive();
  restarted.take_over(2, 1, 500);
  EXPECT_TRUE(restarted.orders().gains.empty());
  EXPECT_TRUE(restarted.orders().modes.empty());
  for (Tick tick = 500; tick < 600; ++tick) {
    EXPECT_TRUE(restarted.step(tick).gains.empty());
    EXPECT_TRUE(restarted.step(tick).modes.empty());
  }
}

TEST(SupervisorOrders, WhoKnowsOfNoGainsDesignsThemFromTheFirstGoodEstimateHoweverNear) {
  const auto estimate = knee_estimate(hyq().joints[kKnee].swing_load, kSwing);  // what it would begin with
  Supervisor informed = adaptive();
  informed.step(0);
  EXPECT_TRUE(issued_by(informed, 1, kLong, estimate).empty());
  Supervisor restarted = adaptive();
  restarted.take_over(2, 1, 0);
  const auto issued = issued_by(restarted, 1, kLong, estimate);
  ASSERT_EQ(issued.size(), 1u) << "once";
  EXPECT_EQ(issued[0].joint, kKnee);
  EXPECT_EQ(issued[0].phase, kSwing);
  EXPECT_EQ(issued[0].authority, 2u);
}

TEST(SupervisorOrders, RequestsAfterATakeOverFollowTheNewestModeThatAnybodyHasHeardOf) {
  Supervisor restarted = adaptive();
  restarted.take_over(2, 7, 500);
  restarted.take(
      signals::SystemRequest{.session = kSession, .tick = 500, .count = 1, .request = signals::Request::kArm});
  const auto& modes = restarted.step(501).modes;
  ASSERT_EQ(modes.size(), 1u);
  EXPECT_EQ(modes[0].epoch, 8u);
  EXPECT_EQ(modes[0].authority, 2u);
}

TEST(SupervisorOrders, WhoStandsDownForgetsWhatItIssued) {
  Supervisor leader = adaptive();
  leader.step(0);
  leader.stand_down();
  EXPECT_TRUE(leader.orders().gains.empty());
  EXPECT_TRUE(leader.orders().modes.empty());
}

}  // namespace orders_test
}  // namespace farrier::supervisor
