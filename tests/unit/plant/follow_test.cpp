// Actuators whose motion is prescribed: the half of a joint left of the load cell.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plant/electric_joint.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/plant/test_drive.hpp"
#include "tests/unit/plant/test_effects.hpp"

namespace farrier::plant::test {
namespace follow_test {

constexpr double kStep_s = 2.5e-5;

/// HyQ's effects, but for the supply of its own.
std::vector<ActiveEffect> lean_effects() {
  return {effect_of("piston_friction", {10.0, 1.3}, hyq_cylinder(), swing_load()),
          effect_of("valve_deadband", {6e-5, 2e-14}, hyq_cylinder(), swing_load())};
}

/// A joint on its load, and one like it that follows the motion of the first.
struct Pair {
  HydraulicJoint free, moved;
  OilAccount account{};
  double largest_error = 0.0, largest_force = 0.0;

  explicit Pair(const std::vector<ActiveEffect>& effects)
      : free(joint_with(hyq_cylinder(), swing_load(), effects)), moved(free) {}

  void run(double time_s, double supply_Pa = 160e5) {
    const int steps = static_cast<int>(std::lround(time_s / kStep_s));
    for (int i = 0; i < steps; ++i) {
      const double current_A = 0.004 * std::sin(2.0 * 3.141592653589793 * 4.0 * i * kStep_s);
      free.step(current_A, 0.0, kStep_s);
      moved.follow(current_A, supply_Pa, {free.state().position, free.state().velocity}, kStep_s, account);
      largest_error = std::max(largest_error, std::abs(moved.load_cell_force() - free.load_cell_force()));
      largest_force = std::max(largest_force, std::abs(free.load_cell_force()));
    }
  }
};

TEST(Follow, GivesTheForceOfAJointThatMovesTheSameWay) {
  for (const auto& effects : {std::vector<ActiveEffect>{}, lean_effects()}) {
    Pair pair(effects);
    pair.run(0.5);
    EXPECT_GT(pair.largest_force, 100.0);
    EXPECT_LT(pair.largest_error, 0.02 * pair.largest_force) << effects.size() << " effects";
    EXPECT_EQ(pair.moved.state().position, pair.free.state().position);
    EXPECT_EQ(pair.moved.state().velocity, pair.free.state().velocity);
  }
}

TEST(Follow, GoesOnWithAnotherValveFromTheSameState) {
  Pair pair(lean_effects());
  pair.run(0.1);
  const State before = pair.moved.state();
  ActuatorParams weak = hyq_cylinder();
  weak.valve_gain *= 0.5;
  ASSERT_TRUE(pair.moved.set_actuator(weak, lean_effects()));
  const State after = pair.moved.state();
  EXPECT_EQ(after.position, before.position);
  EXPECT_EQ(after.pressure_a_Pa, before.pressure_a_Pa);
  EXPECT_EQ(after.pressure_b_Pa, before.pressure_b_Pa);
  EXPECT_EQ(pair.moved.actuator().valve_gain, weak.valve_gain);
  ActuatorParams none = hyq_cylinder();
  none.valve_gain = 0.0;
  EXPECT_FALSE(pair.moved.set_actuator(none, lean_effects()));
  EXPECT_EQ(pair.moved.actuator().valve_gain, weak.valve_gain) << "the old one stays";
}

TEST(Follow, AccountsForTheEnergyOfTheSupply) {
  for (const auto& effects : {std::vector<ActiveEffect>{}, lean_effects()}) {
    Pair pair(effects);
    const double before_J = pair.moved.stored_J();
    pair.run(0.5);
    const OilAccount& a = pair.account;
    EXPECT_GT(a.supply_J, 10.0);
    EXPECT_GT(a.supply_m3, 0.0);
    EXPECT_GT(a.valve_J, 0.0);
    EXPECT_GT(a.friction_J, 0.0);
    const double found_J =
        a.return_J + a.valve_J + a.leakage_J + a.friction_J + a.work_J + pair.moved.stored_J() - before_J;
    EXPECT_NEAR(found_J, a.supply_J, 0.01 * a.supply_J) << effects.size() << " effects";
  }
}

TEST(Follow, HeedsThePressureOfTheSupply) {
  Pair rich(lean_effects());
  Pair poor(lean_effects());
  for (int i = 0; i < 400; ++i) {  // at rest, valve open: the chamber fills up to the supply
    rich.moved.follow(0.01, 160e5, {rich.moved.state().position, 0.0}, kStep_s, rich.account);
    poor.moved.follow(0.01, 100e5, {poor.moved.state().position, 0.0}, kStep_s, poor.account);
  }
  EXPECT_NEAR(rich.moved.state().pressure_a_Pa, 160e5, 1e5);
  EXPECT_NEAR(poor.moved.state().pressure_a_Pa, 100e5, 1e5);
}

TEST(Follow, LeavesTheMassOfThePistonToTheMechanism) {
  Pair pair({});
  OilAccount account;
  const State rest = pair.moved.state();
  pair.moved.follow(0.0, 160e5, {rest.position + 1e-7, 0.004}, kStep_s, account);
  const double acceleration = 0.004 / kStep_s;
  EXPECT_NEAR(pair.moved.mechanism_force() - pair.moved.load_cell_force(), hyq_cylinder().piston_mass * acceleration,
              1e-9);
}

TEST(Follow, RefusesAnEndThatIsNoNumber) {
  Pair pair({});
  OilAccount account;
  const HydraulicJoint before = pair.moved;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(pair.moved.follow(0.0, 160e5, {nan, 0.0}, kStep_s, account).input_refused);
  EXPECT_TRUE(pair.moved.follow(0.0, 160e5, {0.04, nan}, kStep_s, account).input_refused);
  EXPECT_TRUE(pair.moved.follow(0.0, 160e5, {0.04, 0.0}, 0.0, account).input_refused);
  EXPECT_TRUE(same(pair.moved, before));
  EXPECT_TRUE(pair.moved.follow(0.0, nan, {before.state().position, 0.0}, kStep_s, account).input_refused);
}

TEST(Follow, AllocatesNothing) {
  Pair pair(lean_effects());
  OilAccount account;
  const farrier::test::AllocationGuard guard;
  pair.moved.follow(0.001, 160e5, {pair.moved.state().position, 0.0}, kStep_s, account);
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(FollowElectric, GivesTheTorqueOfTheSpringAndDrawsPower) {
  const LoadParams load{.mass = 1.0};
  ElectricJoint joint = ElectricJoint::create(drive(), load, equilibrium(drive(), load, 1.3, 0.0)).value();
  ElectricAccount account;
  for (int i = 0; i < 4000; ++i) {  // a blocked output: the stall torque less the gear's friction
    joint.follow(10.0, {1.3, 0.0}, 2.5e-4, account);
  }
  EXPECT_NEAR(joint.mechanism_force(), 50.0 * 0.1 * 10.0, 2.1);
  EXPECT_NEAR(account.drawn_J, 0.16 * 10.0 * 10.0, 0.5) << "R i^2 for a second";
  EXPECT_EQ(joint.state().position, 1.3);
}

}  // namespace follow_test
}  // namespace farrier::plant::test
