// The supervisor with gains that follow estimates.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "joint_node/gains_check.hpp"
#include "supervisor/supervisor.hpp"
#include "estimates.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::supervisor {
namespace adaptive_test {

using namespace testing;
using signals::JointControllerGains;
using signals::JointModelEstimate;
using signals::JointUpdateDecision;
using signals::UpdateVerdict;

constexpr std::uint64_t kSession = 31;
constexpr std::uint16_t kKnee = 2, kOtherKnee = 5;
constexpr signals::Phase kSwing = signals::Phase::kSwing, kStance = signals::Phase::kStance;
constexpr Tick kLong = 2000;

Supervisor adaptive(std::vector<robot::LoadChange> known = {}) {
  return Supervisor::create(hyq(), Design::kAdaptive, kNoDelay, kSession, std::move(known)).value();
}

/// A sure estimate of what a joint of HyQ carries in stance.
JointModelEstimate stance_of(std::uint16_t joint, signals::Phase phase = kStance) {
  const robot::Joint& of = hyq().joints[joint];
  return estimate_of(robot::model_of(of, of.stance_load, hyq().period_s), joint, phase);
}

struct Issued {
  std::vector<JointControllerGains> gains;
  std::vector<JointUpdateDecision> decisions;
  std::size_t modes = 0;
};

/// Runs from tick 1 on; `estimates(tick)` arrive before each step that follows an estimate's tick.
template <typename Estimates>
Issued run(Supervisor& supervisor, Tick ticks, Estimates estimates) {
  supervisor.step(0);
  Issued issued;
  for (Tick tick = 1; tick <= ticks; ++tick) {
    if (hyq().estimate_due(tick - 1)) {
      for (const JointModelEstimate& estimate : estimates(tick)) {
        supervisor.take(estimate, tick);
      }
    }
    const Supervisor::Outputs& outputs = supervisor.step(tick);
    EXPECT_EQ(outputs.decisions.size(), outputs.design_statuses.size());
    issued.gains.insert(issued.gains.end(), outputs.gains.begin(), outputs.gains.end());
    issued.decisions.insert(issued.decisions.end(), outputs.decisions.begin(), outputs.decisions.end());
    issued.modes += outputs.modes.size();
    for (const JointControllerGains& gains : outputs.gains) {
      EXPECT_EQ(gains.effective_tick, tick + hyq().update_logic.gain_lead_ticks);
    }
  }
  return issued;
}

TEST(AdaptiveSupervisor, BeginsWithTheSwingDesignInBothSlots) {
  Supervisor supervisor = adaptive();
  const auto gains = supervisor.step(0).gains;
  Supervisor swing = Supervisor::create(hyq(), Design::kSwing, kNoDelay, kSession).value();
  const auto expected = swing.step(0).gains;
  ASSERT_EQ(gains.size(), expected.size());
  for (std::size_t i = 0; i < gains.size(); ++i) {
    EXPECT_EQ(gains[i].k_force, expected[i].k_force);
    EXPECT_EQ(gains[i].generation, expected[i].generation);
  }
}

TEST(AdaptiveSupervisor, RedesignsTheSlotThatTheEstimateIsAbout) {
  Supervisor supervisor = adaptive();
  const Issued issued = run(supervisor, kLong, [](Tick) { return std::vector{stance_of(kKnee)}; });
  ASSERT_EQ(issued.gains.size(), 1u) << "once: then the gains are what the estimate asks for";
  const JointControllerGains& gains = issued.gains[0];
  EXPECT_EQ(gains.joint, kKnee);
  EXPECT_EQ(gains.phase, kStance);
  const robot::Joint& knee = hyq().joints[kKnee];
  EXPECT_EQ(gains.k_force, design_joint(knee, knee.stance_load, hyq().period_s, kNoDelay).value().force);
  EXPECT_TRUE(joint_node::check_gains(gains, control::Kind::kLqr)) << "a joint takes them";
  EXPECT_EQ(issued.modes, 0u);
}

TEST(AdaptiveSupervisor, NumbersTheGainsOfAJointOneByOneWhateverTheSlot) {
  Supervisor supervisor = adaptive();
  const Issued issued = run(supervisor, kLong, [](Tick tick) {
    const signals::Phase phase = tick / 200 % 2 == 0 ? kSwing : kStance;
    const std::uint16_t joint = tick / 500 % 2 == 0 ? kKnee : kOtherKnee;
    return std::vector{stance_of(joint, phase)};
  });
  std::map<int, std::uint32_t> newest{{kKnee, 2}, {kOtherKnee, 2}};
  for (const JointControllerGains& gains : issued.gains) {
    EXPECT_EQ(gains.generation, ++newest.at(gains.joint));
  }
  EXPECT_EQ(newest.at(kKnee), 4u) << "both slots";
  EXPECT_EQ(newest.at(kOtherKnee), 4u);
}

TEST(AdaptiveSupervisor, TellsWhatItDecidedWithTheGenerationAndTheEvidence) {
  Supervisor supervisor = adaptive();
  const Issued issued = run(supervisor, kLong, [](Tick) { return std::vector{stance_of(kKnee)}; });
  const auto accepted =
      std::ranges::find_if(issued.decisions, [](const auto& d) { return verdict_of(d) == UpdateVerdict::kAccepted; });
  ASSERT_NE(accepted, issued.decisions.end());
  EXPECT_EQ(accepted->joint, kKnee);
  EXPECT_EQ(accepted->phase, kStance);
  EXPECT_EQ(accepted->generation, issued.gains.at(0).generation);
  EXPECT_EQ(accepted->tick, issued.gains.at(0).effective_tick - hyq().update_logic.gain_lead_ticks);
  EXPECT_EQ(accepted->model_a, stance_of(kKnee).a);
  EXPECT_EQ(accepted->validity, stance_of(kKnee).validity);
  EXPECT_GT(accepted->pole_distance, 0.0);
  for (const JointUpdateDecision& decision : issued.decisions) {
    if (verdict_of(decision) != UpdateVerdict::kAccepted) {
      EXPECT_EQ(decision.generation, 2u) << "a refusal names the gains that go on acting";
    }
  }
}

TEST(AdaptiveSupervisor, GoesOnWithTheLastGainsWhenEstimatesCease) {
  Supervisor supervisor = adaptive();
  constexpr Tick kDies = 3;
  const Issued issued = run(supervisor, kLong, [](Tick tick) {
    return tick <= kDies ? std::vector{stance_of(kKnee)} : std::vector<JointModelEstimate>{};
  });
  EXPECT_TRUE(issued.gains.empty());
  EXPECT_TRUE(issued.decisions.empty());
  EXPECT_EQ(issued.modes, 0u) << "the robot stays armed";
}

TEST(AdaptiveSupervisor, CountsOneEstimateOfAJointBetweenTwoSteps) {
  Supervisor once = adaptive(), often = adaptive();
  const Issued expected = run(once, kLong, [](Tick) { return std::vector{stance_of(kKnee)}; });
  const Issued repeated = run(often, kLong, [](Tick) { return std::vector(7, stance_of(kKnee)); });
  ASSERT_EQ(repeated.gains.size(), expected.gains.size());
  EXPECT_EQ(repeated.gains.at(0).effective_tick, expected.gains.at(0).effective_tick) << "repeating is no evidence";
}

TEST(AdaptiveSupervisor, IgnoresEstimatesOfWhatTheRobotDoesNotHave) {
  Supervisor supervisor = adaptive();
  const Issued issued = run(supervisor, kLong, [](Tick) {
    JointModelEstimate no_joint = stance_of(kKnee), no_phase = stance_of(kKnee);
    no_joint.joint = 12;
    no_phase.phase = static_cast<signals::Phase>(2);
    return std::vector{no_joint, no_phase};
  });
  EXPECT_TRUE(issued.gains.empty());
}

TEST(AdaptiveSupervisor, IssuesGainsThatTheJointTakesWhateverPhysicsCameWithTheEstimate) {
  Supervisor supervisor = adaptive();
  const Issued issued = run(supervisor, kLong, [](Tick) {
    JointModelEstimate estimate = stance_of(kKnee);
    estimate.has_physics = 1;
    estimate.physics.fill(std::numeric_limits<double>::quiet_NaN());
    return std::vector{estimate};
  });
  EXPECT_FALSE(issued.gains.empty());
  for (const JointControllerGains& gains : issued.gains) {
    EXPECT_TRUE(joint_node::check_gains(gains, hyq().joints[kKnee].kind).ok());
  }
}

TEST(AdaptiveSupervisor, IsTheOnlyOneThatLooksAtEstimates) {
  for (const Design design : {Design::kStance, Design::kSwing, Design::kPhases}) {
    Supervisor supervisor = Supervisor::create(hyq(), design, kNoDelay, kSession).value();
    const Issued issued = run(supervisor, kLong, [](Tick) { return std::vector{stance_of(kKnee), stance_of(1)}; });
    EXPECT_TRUE(issued.gains.empty() && issued.decisions.empty());
  }
}

TEST(AdaptiveSupervisor, StepsAndTakesWithoutAllocationAlsoWhenEveryJointIsRedesigned) {
  const auto knows = hyq().joints[kKnee].stance_load;
  Supervisor supervisor = adaptive({{20, kKnee, knows}, {21, kKnee, knows}, {22, kKnee, knows}});
  std::size_t redesigned = 0;
  const test::AllocationGuard guard;
  for (Tick tick = 0; tick < kLong; ++tick) {
    for (const robot::Joint& joint : hyq().joints) {
      supervisor.take(stance_of(joint.number, tick / 300 % 2 == 0 ? kSwing : kStance), tick);
    }
    redesigned += supervisor.step(tick).decisions.size();
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_GE(redesigned, 16u) << "both slots of eight joints that flex";
}

}  // namespace adaptive_test
}  // namespace farrier::supervisor
