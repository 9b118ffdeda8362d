// The supervisor that begins with given gains in place of designs for bench loads.

#include <gtest/gtest.h>

#include "supervisor/supervisor.hpp"
#include "estimates.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::supervisor {
namespace first_gains_test {

using namespace testing;
using signals::JointControllerGains;
using signals::Phase;

constexpr std::uint64_t kSession = 31;
constexpr std::uint16_t kKnee = 2;
constexpr signals::Phase kStance = signals::Phase::kStance;
constexpr Tick kLong = 2000;

/// Gains that no design has: every slot of every joint its own.
std::vector<SlotGains> distinct() {
  std::vector<SlotGains> first;
  for (const robot::Joint& joint : hyq().joints) {
    const control::Gains gains = design_joint(joint, joint.swing_load, hyq().period_s, kNoDelay).value();
    SlotGains slots{gains, gains};
    slots[0].force *= 1.0 + 0.001 * joint.number;
    slots[1].force *= 0.9 - 0.001 * joint.number;
    first.push_back(slots);
  }
  return first;
}

std::vector<SlotGains> for_stance() {
  std::vector<SlotGains> first;
  for (const robot::Joint& joint : hyq().joints) {
    SlotGains slots;
    slots.fill(design_joint(joint, joint.stance_load, hyq().period_s, kNoDelay).value());
    first.push_back(slots);
  }
  return first;
}

Supervisor begun_with(const std::vector<SlotGains>& first, Design design) {
  return Supervisor::create(hyq(), design, kNoDelay, kSession, {}, first).value();
}

/// Updates issued after the start while a knee's stance slot gets sure estimates of its stance load.
std::size_t updates(Supervisor supervisor) {
  const robot::Joint& knee = hyq().joints[kKnee];
  const auto estimate = estimate_of(robot::model_of(knee, knee.stance_load, hyq().period_s), kKnee, kStance);
  supervisor.step(0);
  std::size_t issued = 0;
  for (Tick tick = 1; tick <= kLong; ++tick) {
    if (hyq().estimate_due(tick - 1)) {
      supervisor.take(estimate, tick);
    }
    issued += supervisor.step(tick).gains.size();
  }
  return issued;
}

TEST(SupervisorFirstGains, AreIssuedInTheirSlotsAsTheyAre) {
  const std::vector<SlotGains> first = distinct();
  Supervisor supervisor = begun_with(first, Design::kStance);
  const std::vector<JointControllerGains>& issued = supervisor.step(0).gains;
  ASSERT_EQ(issued.size(), signals::kPhaseCount * hyq().joints.size());
  for (std::size_t i = 0; i < issued.size(); ++i) {
    const auto phase = issued[i].phase;
    const control::Gains& gains = first.at(issued[i].joint)[issued[i].phase];
    const JointControllerGains expected =
        wire_gains::pack_gains(issued[i].joint, phase, 1, static_cast<unsigned>(phase) + 1, gains);
    EXPECT_EQ(issued[i].joint, i / signals::kPhaseCount);
    EXPECT_EQ(static_cast<std::size_t>(issued[i].phase), i % signals::kPhaseCount);
    EXPECT_EQ(issued[i].generation, expected.generation);
    EXPECT_EQ(issued[i].k_force, expected.k_force);
    EXPECT_EQ(issued[i].k_integral, expected.k_integral);
    EXPECT_EQ(issued[i].model_a, expected.model_a);
  }
}

TEST(SupervisorFirstGains, StayWithoutAdaptation) { EXPECT_EQ(updates(begun_with(distinct(), Design::kStance)), 0u); }

TEST(SupervisorFirstGains, AreWhatAdaptationHoldsEstimatesAgainst) {
  EXPECT_EQ(updates(begun_with(for_stance(), Design::kAdaptive)), 0u) << "they are for what is estimated";
  EXPECT_EQ(updates(begun_with(distinct(), Design::kAdaptive)), 1u) << "those are for the swing load";
}

TEST(SupervisorFirstGains, AreRefusedUnlessTheyAreForEveryJoint) {
  std::vector<SlotGains> short_of_one = distinct();
  short_of_one.pop_back();
  const auto refused = Supervisor::create(hyq(), Design::kStance, kNoDelay, kSession, {}, short_of_one);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("11 joints"), std::string::npos) << refused.error().message;
}

TEST(SupervisorFirstGains, AreRefusedForAnotherDelayThanTheLoopHas) {
  const auto refused = Supervisor::create(hyq(), Design::kStance, kNoDelay + 1, kSession, {}, distinct());
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find(hyq().joints[0].name), std::string::npos) << refused.error().message;
}

// A robot on a ground would stand on gains for its swinging legs until an estimate comes.
TEST(FirstGains, OfAdaptationOnAGroundAreThoseOfEachPhaseAndItsLoadMustBeHeld) {
  robot::Robot walking = hyq();
  walking.on_ground = true;
  const robot::Joint& knee = walking.joints[kKnee];
  const auto stance = [](const robot::Robot& robot) {
    Supervisor supervisor = Supervisor::create(robot, Design::kAdaptive, kNoDelay, kSession).value();
    for (const JointControllerGains& gains : supervisor.step(0).gains) {
      if (gains.joint == kKnee && gains.phase == kStance) {
        return wire_gains::unpack_gains(gains);
      }
    }
    return control::Gains{};
  };
  const control::Gains own = design_joint(knee, knee.stance_load, walking.period_s, kNoDelay).value();
  EXPECT_EQ(stance(walking).force, own.force);
  EXPECT_NE(stance(hyq()).force, own.force);
  ASSERT_EQ(loads_to_hold(walking, knee, kStance).size(), 1u);
  EXPECT_EQ(loads_to_hold(walking, knee, kStance)[0].mass, knee.stance_load.mass);
  EXPECT_EQ(loads_to_hold(walking, knee, Phase::kSwing)[0].mass, knee.swing_load.mass);
  EXPECT_TRUE(loads_to_hold(hyq(), knee, kStance).empty());
}

}  // namespace first_gains_test
}  // namespace farrier::supervisor
