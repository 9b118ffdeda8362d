// Which estimates become physics for a joint that inverts the flow law.

#include "supervisor/physics_update.hpp"

#include <cmath>
#include <limits>

#include "joint_node/gains_check.hpp"
#include "supervisor/supervisor.hpp"
#include "estimates.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::supervisor {
namespace physics_update_test {

using namespace testing;
using plant::JointPhysics;
using signals::JointModelEstimate;
using signals::UpdateVerdict;

constexpr double kLight_kg = 0.5, kHeavy_kg = 50.0;  // of Fig. 7.6
constexpr int kLong = 100;                           // looks: a second

JointPhysics physics_for(double mass_kg) { return plant::nominal_physics(rig().joints[0].actuator, cart(mass_kg)); }

PhysicsUpdate slot_for(const JointPhysics& first, const robot::UpdateLogicParams& logic = rig().update_logic) {
  robot::Joint joint = rig().joints[0];
  joint.kind = control::Kind::kFlowInversion;
  return PhysicsUpdate(joint, logic, rig().period_s, rig().estimate_period_ticks, kNoDelay, first);
}

/// A sure estimate of these physics.
JointModelEstimate estimate_of(const JointPhysics& physics) {
  JointModelEstimate estimate = testing::estimate_of(model_of(cart(physics.load_mass)));
  estimate.has_physics = 1;
  estimate.physics = plant::values_of(physics);
  return estimate;
}

UpdateVerdict verdict_on(PhysicsUpdate& slot, const JointModelEstimate& estimate) {
  return verdict_of(slot.look(estimate, 0));
}

/// Looks until the same estimate is accepted, kLong + 1 when it never is.
int looks_until_accepted(PhysicsUpdate& slot, const JointModelEstimate& estimate) {
  for (int look = 1; look <= kLong; ++look) {
    if (verdict_on(slot, estimate) == UpdateVerdict::kAccepted) {
      return look;
    }
  }
  return kLong + 1;
}

TEST(PhysicsUpdate, LeavesPhysicsAloneThatAreWhatIsEstimated) {
  PhysicsUpdate slot = slot_for(physics_for(10.0));
  EXPECT_EQ(verdict_on(slot, estimate_of(physics_for(10.0))), UpdateVerdict::kNotDifferentEnough);
  EXPECT_FALSE(slot.is_news());
}

TEST(PhysicsUpdate, TakesAChangeOfAnyOneBeyondItsLeastShareAtOnce) {
  const double least = rig().update_logic.physics_change_min;
  for (const auto member :
       {&JointPhysics::load_mass, &JointPhysics::damping, &JointPhysics::valve_gain, &JointPhysics::bulk_modulus}) {
    const JointPhysics first = physics_for(10.0);
    JointPhysics changed = first;
    changed.*member *= 1.0 + 0.9 * least;
    PhysicsUpdate slot = slot_for(first);
    EXPECT_EQ(verdict_on(slot, estimate_of(changed)), UpdateVerdict::kNotDifferentEnough);
    changed.*member = first.*member * (1.0 + 1.1 * least);
    EXPECT_EQ(verdict_on(slot, estimate_of(changed)), UpdateVerdict::kAccepted);
    EXPECT_TRUE(slot.is_news());
    EXPECT_EQ(slot.physics().*member, changed.*member);
    EXPECT_EQ(verdict_on(slot, estimate_of(changed)), UpdateVerdict::kNotDifferentEnough) << "they are what acts now";
  }
}

TEST(PhysicsUpdate, MeasuresForcesByTheForceThatCountsAsOne) {
  const double scale_N = rig().joints[0].normalisation.force;
  const double least = rig().update_logic.physics_change_min;
  for (const auto member : {&JointPhysics::bias_force, &JointPhysics::coulomb}) {
    JointPhysics changed = physics_for(10.0);
    changed.*member = 0.9 * least * scale_N;
    PhysicsUpdate slot = slot_for(physics_for(10.0));
    EXPECT_EQ(verdict_on(slot, estimate_of(changed)), UpdateVerdict::kNotDifferentEnough);
    changed.*member = 1.1 * least * scale_N;
    EXPECT_EQ(verdict_on(slot, estimate_of(changed)), UpdateVerdict::kAccepted);
  }
}

TEST(PhysicsUpdate, LeavesAChangeAloneThatIsWithinItsStandardError) {
  JointModelEstimate unsure = estimate_of(physics_for(12.0));
  unsure.physics_error[0] = 2.5;
  PhysicsUpdate slot = slot_for(physics_for(10.0));
  EXPECT_EQ(verdict_on(slot, unsure), UpdateVerdict::kNotDifferentEnough);
  unsure.physics_error[0] = 1.5;
  EXPECT_EQ(verdict_on(slot, unsure), UpdateVerdict::kAccepted);
}

TEST(PhysicsUpdate, RefusesWhatIsNoEstimateOfPhysics) {
  const auto verdict_when = [](auto change) {
    PhysicsUpdate slot = slot_for(physics_for(10.0));
    JointModelEstimate estimate = estimate_of(physics_for(12.0));
    change(estimate);
    const UpdateVerdict verdict = verdict_on(slot, estimate);
    EXPECT_EQ(slot.physics().load_mass, verdict == UpdateVerdict::kAccepted ? 12.0 : 10.0);
    return verdict;
  };
  const double least = rig().update_logic.validity_min;
  EXPECT_EQ(verdict_when([](auto& e) { e.has_physics = 0; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.validity = 0.0; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([&](auto& e) { e.validity = 0.9 * least; }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.validity = std::nan(""); }), UpdateVerdict::kNotValid);
  EXPECT_EQ(verdict_when([](auto& e) { e.a[4] = INFINITY; }), UpdateVerdict::kNotValid);
  for (std::size_t i = 0; i < plant::kPhysicsCount; ++i) {
    EXPECT_EQ(verdict_when([i](auto& e) { e.physics[i] = std::nan(""); }), UpdateVerdict::kNotValid) << i;
    if (i != plant::kBiasForce) {
      EXPECT_EQ(verdict_when([i](auto& e) { e.physics[i] = -1.0; }), UpdateVerdict::kNotValid) << i;
    }
  }
  EXPECT_EQ(verdict_when([](auto&) {}), UpdateVerdict::kAccepted) << "unchanged";
}

TEST(PhysicsUpdate, TakesAValveThatCountsAsStrongerAtOnceAndNothingElseOfItsEstimate) {
  PhysicsUpdate slot = slot_for(physics_for(10.0));
  JointPhysics counted = physics_for(12.0);
  counted.valve_gain *= 1.5;
  JointModelEstimate estimate = estimate_of(counted);
  estimate.validity = 0.0;
  estimate.flags = bit(estimation::EstimateFlag::kCountsAsStronger);
  EXPECT_EQ(verdict_on(slot, estimate), UpdateVerdict::kAccepted);
  EXPECT_EQ(slot.physics().valve_gain, counted.valve_gain);
  EXPECT_EQ(slot.physics().load_mass, 10.0);
  EXPECT_EQ(verdict_on(slot, estimate), UpdateVerdict::kNotValid) << "it has been taken";
  estimate.physics[plant::kBiasForce + 1] = 2.0 * counted.valve_gain;
  estimate.b[2] = INFINITY;
  EXPECT_EQ(verdict_on(slot, estimate), UpdateVerdict::kNotValid);
  estimate.physics[plant::kBiasForce + 1] = std::nan("");
  EXPECT_EQ(verdict_on(slot, estimate), UpdateVerdict::kNotValid);
}

// 100 ms: half of what a run of Fig. 7.8 may take before it is judged.
TEST(PhysicsUpdate, TakesTheOtherLoadOfTheCycleWithinATenthOfASecondWhateverItsSign) {
  const int most = static_cast<int>(std::llround(0.1 / (rig().period_s * rig().estimate_period_ticks)));
  PhysicsUpdate light = slot_for(physics_for(kLight_kg));
  EXPECT_LE(looks_until_accepted(light, estimate_of(physics_for(kHeavy_kg))), most);
  PhysicsUpdate heavy = slot_for(physics_for(kHeavy_kg));
  EXPECT_LE(looks_until_accepted(heavy, estimate_of(physics_for(kLight_kg))), most);
}

// A valve gain told ten times too low makes the law ten times too strong: on the stored joint it cannot settle.
TEST(PhysicsUpdate, DoesNotTakeAtOnceWhatWouldNotSettleOnTheStoredJoint) {
  JointPhysics wild = physics_for(10.0);
  wild.valve_gain *= 0.1;
  PhysicsUpdate slot = slot_for(physics_for(10.0));
  EXPECT_EQ(verdict_on(slot, estimate_of(wild)), UpdateVerdict::kUnstableOnStoredModel);
  EXPECT_TRUE(slot.is_news());
  EXPECT_EQ(slot.physics().valve_gain, physics_for(10.0).valve_gain);
  EXPECT_EQ(verdict_on(slot, estimate_of(wild)), UpdateVerdict::kUnstableOnStoredModel);
  EXPECT_FALSE(slot.is_news()) << "refused for the same reason";
}

TEST(PhysicsUpdate, LookDoesNotAllocate) {
  PhysicsUpdate slot = slot_for(physics_for(kLight_kg));
  const JointModelEstimate estimate = estimate_of(physics_for(kHeavy_kg));
  const farrier::test::AllocationGuard guard;
  for (int look = 0; look < 20; ++look) {
    slot.look(estimate, look);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

robot::Robot inverting() {
  robot::Robot robot = rig();
  robot.joints[0].kind = control::Kind::kFlowInversion;
  return robot;
}

TEST(SupervisorPhysics, ComesWithEveryFirstSetOfGainsAsTheNominalLoadHasIt) {
  const robot::Joint& joint = rig().joints[0];
  for (const Design design : {Design::kStance, Design::kSwing, Design::kPhases, Design::kAdaptive}) {
    Supervisor supervisor = Supervisor::create(inverting(), design, kNoDelay, 1).value();
    for (const signals::JointControllerGains& gains : supervisor.step(0).gains) {
      const bool stance = gains.phase == signals::Phase::kStance;
      const bool heavy = design == Design::kStance || (stance && design != Design::kSwing);
      const JointPhysics expected =
          plant::nominal_physics(joint.actuator, heavy ? joint.stance_load : joint.swing_load);
      EXPECT_EQ(gains.has_physics, 1);
      EXPECT_EQ(gains.physics, plant::values_of(expected));
      EXPECT_TRUE(joint_node::check_gains(gains, control::Kind::kFlowInversion));
    }
  }
}

TEST(SupervisorPhysics, IsThatOfAKnownLoadFromItsTickOn) {
  const std::vector<robot::LoadChange> known{{100, 0, cart(kHeavy_kg)}};
  Supervisor supervisor = Supervisor::create(inverting(), Design::kSwing, kNoDelay, 1, known).value();
  std::vector<signals::JointControllerGains> issued;
  for (Tick tick = 0; tick < 200; ++tick) {
    const auto& gains = supervisor.step(tick).gains;
    issued.insert(issued.end(), gains.begin(), gains.end());
  }
  ASSERT_EQ(issued.size(), 4u);
  EXPECT_EQ(issued.back().effective_tick, 100);
  EXPECT_EQ(issued.back().physics, plant::values_of(physics_for(kHeavy_kg)));
}

TEST(SupervisorPhysics, GoesOutWithAnAcceptedEstimateAndItsDecision) {
  Supervisor supervisor = Supervisor::create(inverting(), Design::kAdaptive, kNoDelay, 1).value();
  supervisor.step(0);
  const JointModelEstimate estimate = estimate_of(physics_for(3.0));
  supervisor.take(estimate, 10);
  const Supervisor::Outputs& out = supervisor.step(10);
  ASSERT_EQ(out.gains.size(), 1u);
  EXPECT_EQ(out.gains[0].generation, 3u);
  EXPECT_EQ(out.gains[0].has_physics, 1);
  EXPECT_EQ(out.gains[0].physics, estimate.physics);
  EXPECT_EQ(out.gains[0].model_a, estimate.a);
  EXPECT_EQ(out.gains[0].effective_tick, 10 + rig().update_logic.gain_lead_ticks);
  EXPECT_TRUE(joint_node::check_gains(out.gains[0], control::Kind::kFlowInversion));
  ASSERT_EQ(out.decisions.size(), 1u);
  EXPECT_EQ(verdict_of(out.decisions[0]), UpdateVerdict::kAccepted);
  EXPECT_EQ(out.decisions[0].generation, 3u);
}

}  // namespace physics_update_test
}  // namespace farrier::supervisor
