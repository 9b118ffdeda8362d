#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "test_joints.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::plant {
namespace effects_test {

using test::kPeriod_s;

constexpr FrictionParams kRigFriction{40.0, 60.0, 0.01, 1e-5};
constexpr LineParams kRigLine{.length_m = 0.6};

ActuatorParams with_everything() {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.spool.on = true;
  actuator.valve_deadband_A = 6e-5;
  actuator.line = kRigLine;
  return actuator;
}

LoadParams sticky_load() {
  LoadParams load{2.5, 500.0, 21480.0, 0.04};
  load.friction = kRigFriction;
  return load;
}

/// Way of a spool, the sum of its mean openings over substeps, `parts` in 2 ms, under a current that jumps; A s.
double way_of_spool(int parts) {
  constexpr double kSeconds = 2e-3;
  const std::array fitted{1.0 / 1600.0, 0.7};
  const Scales scales(test::rig_cylinder(), test::swing_load());
  ValveDynamics<double> spool(fitted.data(), scales, kSeconds / parts);
  double sum = 0.0;
  for (int i = 0; i < 4 * parts; ++i) {
    ValveMoment<double> valve{i < 2 * parts ? 1e-3 : -2e-3, 1.0};
    spool.on_valve(valve);
    sum += valve.opening_A * kSeconds / parts;
  }
  return sum;
}

TEST(ValveDynamics, MeanOpeningsAddToTheSameWayOverSubstepsOfAnyLength) {
  EXPECT_NEAR(way_of_spool(1), way_of_spool(64), 1e-15);
  EXPECT_NEAR(way_of_spool(4), way_of_spool(64), 1e-15);
}

bool same(const HydraulicJoint& one, const HydraulicJoint& other) {
  const State& a = one.state();
  const State& b = other.state();
  return a.position == b.position && a.velocity == b.velocity && a.pressure_a_Pa == b.pressure_a_Pa &&
         a.pressure_b_Pa == b.pressure_b_Pa && one.load_cell_force() == other.load_cell_force();
}

// The neutral joint runs equations that know no effects. A deadband of 1e-300 A makes a joint run the others, and
// changes no current above 1e-284 A: same bits, so that the effects' absence is worth nothing whichever way it is run.
TEST(Effects, OfNoSizeGiveTheSameBitsAsNone) {
  ActuatorParams barely = test::hyq_cylinder();
  barely.valve_deadband_A = 1e-300;
  HydraulicJoint with = test::joint_at_rest(barely, test::swing_load());
  HydraulicJoint without = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  test::ValveNoise noise(0.5, 0.1);
  for (int tick = 0; tick < 2000; ++tick) {
    const double current = noise.next(without.actuator(), without.state().position);
    with.step(current, 30.0, kPeriod_s);
    without.step(current, 30.0, kPeriod_s);
    ASSERT_TRUE(same(with, without)) << "tick " << tick;
  }
}

TEST(Effects, AreReadAsTheValveHasThemWhereThereAreNone) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  joint.step(0.002, 0.0, kPeriod_s);
  const EffectReadings readings = joint.effects();
  EXPECT_EQ(readings.opening_A, 0.002);
  EXPECT_EQ(readings.line_pressure_a_Pa, joint.state().pressure_a_Pa);
  EXPECT_EQ(readings.line_flow_a_m3_s, 0.0);
  EXPECT_EQ(readings.friction, 0.0);
}

// (2.19) for a step of u: u_v = u (1 - exp(-D w t) (cos w_d t + D / sqrt(1 - D^2) sin w_d t)).
TEST(Spool, FollowsAStepAsItsTransferFunctionDoes) {
  constexpr double kTolerance = 1e-9;
  ActuatorParams actuator = test::rig_cylinder();
  actuator.spool.on = true;
  HydraulicJoint joint = test::joint_at_rest(actuator, test::stance_load(), kTolerance);
  constexpr double kStep_A = 0.004;  // its overshoot of 16 % stays inside the valve
  const double omega = actuator.spool.natural_frequency_rad_s;
  const double D = actuator.spool.damping;
  const double damped = omega * std::sqrt(1.0 - D * D);
  constexpr double kSample_s = 1e-4;
  double stated = 0.0;
  for (int i = 1; i <= 200; ++i) {
    const StepReport report = joint.step(kStep_A, 0.0, kSample_s);
    stated += report.error_position / actuator.stroke;  // relative to each state's own scale, the spool's 10 mA
    const double t = i * kSample_s;
    const double expected =
        kStep_A *
        (1.0 - std::exp(-D * omega * t) * (std::cos(damped * t) + D / std::sqrt(1 - D * D) * std::sin(damped * t)));
    ASSERT_NEAR(joint.effects().opening_A, expected, 8.0 * stated * actuator.valve_current_max_A) << "at " << t << " s";
  }
  EXPECT_LT(stated, 1e-5);
}

TEST(Spool, OpensNoFurtherThanTheValveDoes) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.spool = {true, 1570.0, 0.2};  // overshoots by half
  HydraulicJoint joint = test::joint_at_rest(actuator, test::stance_load());
  double largest_A = 0.0;
  for (int i = 0; i < 200; ++i) {
    joint.step(actuator.valve_current_max_A, 0.0, 1e-4);
    largest_A = std::max(largest_A, joint.effects().opening_A);
  }
  EXPECT_EQ(largest_A, actuator.valve_current_max_A);
}

TEST(Spool, SwitchedOffChangesNoBit) {
  ActuatorParams off = test::rig_cylinder();
  off.spool = {false, 300.0, 0.1};
  HydraulicJoint with = test::joint_at_rest(off, test::swing_load());
  HydraulicJoint without = test::joint_at_rest(test::rig_cylinder(), test::swing_load());
  for (int tick = 0; tick < 200; ++tick) {
    with.step(0.003, 0.0, kPeriod_s);
    without.step(0.003, 0.0, kPeriod_s);
    ASSERT_TRUE(same(with, without));
  }
}

// Powers of two: the difference of currents is exact, and so must be what comes of it.
TEST(Deadband, ShiftsCurrentsBeyondItAndSwallowsThoseWithin) {
  constexpr double kHalfWidth_A = 0x1p-13;
  ActuatorParams actuator = test::rig_cylinder();
  actuator.valve_deadband_A = kHalfWidth_A;
  struct Pair {
    double command_A, opening_A;
  };
  for (const auto& [command, opening] :
       {Pair{0.0, 0.0}, Pair{kHalfWidth_A, 0.0}, Pair{-kHalfWidth_A, 0.0}, Pair{3 * kHalfWidth_A, 2 * kHalfWidth_A},
        Pair{-5 * kHalfWidth_A, -4 * kHalfWidth_A}}) {
    HydraulicJoint with = test::joint_at_rest(actuator, test::swing_load());
    HydraulicJoint without = test::joint_at_rest(test::rig_cylinder(), test::swing_load());
    for (int tick = 0; tick < 100; ++tick) {
      with.step(command, 20.0, kPeriod_s);
      without.step(opening, 20.0, kPeriod_s);
      ASSERT_EQ(with.effects().opening_A, opening);
      ASSERT_TRUE(same(with, without)) << command << " at tick " << tick;
    }
  }
}

TEST(Effects, AreRefusedByNameWhereNoMachineHasThem) {
  ActuatorParams actuator = with_everything();
  actuator.spool.damping = 0.0;
  actuator.valve_deadband_A = 0.02;
  actuator.line.bore_m = -1.0;
  LoadParams load = sticky_load();
  load.friction.breakaway = 10.0;
  const auto joint = HydraulicJoint::create(actuator, load, {0.04, 0.0, 50e5, 80e5});
  ASSERT_FALSE(joint.ok());
  for (const char* word : {"spool: damping", "deadband_A", "bore_m", "friction: breakaway"}) {
    EXPECT_NE(joint.error().message.find(word), std::string::npos) << word << " missing: " << joint.error().message;
  }
}

TEST(Effects, TooFastForTheShortestSubstepAreRefused) {
  LoadParams load = sticky_load();
  load.friction.presliding = 1e-9;
  const auto joint = HydraulicJoint::create(test::rig_cylinder(), load, {0.04, 0.0, 50e5, 80e5});
  ASSERT_FALSE(joint.ok());
  EXPECT_NE(joint.error().message.find("presliding"), std::string::npos) << joint.error().message;
  HydraulicJoint good = test::joint_at_rest(test::rig_cylinder(), test::swing_load());
  EXPECT_FALSE(good.set_load(load));
  load.friction = {40.0, std::numeric_limits<double>::quiet_NaN(), 0.01, 1e-5};
  EXPECT_FALSE(good.set_load(load));
  EXPECT_EQ(good.load().friction.coulomb, 0.0);
}

TEST(Effects, StayPhysicalTogetherUnderViolentValveNoise) {
  HydraulicJoint joint = test::joint_at_rest(with_everything(), sticky_load());
  test::ValveNoise noise(2.0, 1.0);
  for (int tick = 0; tick < 3000; ++tick) {
    const StepReport report = joint.step(noise.next(joint.actuator(), joint.state().position), 0.0, kPeriod_s);
    const State& s = joint.state();
    const EffectReadings e = joint.effects();
    ASSERT_GE(std::min({s.pressure_a_Pa, s.pressure_b_Pa, e.line_pressure_a_Pa, e.line_pressure_b_Pa}), 0.0);
    ASSERT_LT(std::max({s.pressure_a_Pa, s.pressure_b_Pa, e.line_pressure_a_Pa, e.line_pressure_b_Pa}), 100e6);
    // A step states an error of the friction's state: 1e-6 of the supply's full push, 2500 N, per substep.
    ASSERT_LE(std::abs(e.friction), kRigFriction.breakaway + 0.05) << "tick " << tick;
    ASSERT_LE(std::abs(e.opening_A), joint.actuator().valve_current_max_A);
    ASSERT_TRUE(std::isfinite(joint.load_cell_force()));
    ASSERT_LE(report.substeps, static_cast<int>(2.0 * kPeriod_s / HydraulicJoint::kShortestSubstep_s) + 1);
  }
}

TEST(Effects, TreatNonFiniteInputAsNull) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  HydraulicJoint joint = test::joint_at_rest(with_everything(), sticky_load());
  HydraulicJoint null_valve = joint;
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(joint.step(bad, bad, kPeriod_s).input_refused);
    null_valve.step(0.0, 0.0, kPeriod_s);
    EXPECT_TRUE(same(joint, null_valve));
  }
}

TEST(Effects, StepDoesNotAllocate) {
  HydraulicJoint joint = test::joint_at_rest(with_everything(), sticky_load());
  const farrier::test::AllocationGuard guard;
  for (int tick = 0; tick < 100; ++tick) {
    joint.step(tick % 2 == 0 ? 0.01 : -0.004, 50.0, kPeriod_s);
  }
  joint.set_load(test::stance_load());
  EXPECT_EQ(guard.allocations(), 0u);
}

// With every effect at once the integrator must be as accurate as it states, compared with a finer tolerance.
TEST(Effects, TighterToleranceBringsTheTrajectoryCloser) {
  HydraulicJoint finest = test::joint_at_rest(with_everything(), sticky_load(), 1e-11);
  HydraulicJoint fine = test::joint_at_rest(with_everything(), sticky_load(), 1e-8);
  HydraulicJoint coarse = test::joint_at_rest(with_everything(), sticky_load(), 1e-5);
  double fine_worst_m = 0.0;
  double coarse_worst_m = 0.0;
  test::ValveNoise noise(0.1, 0.01);
  for (int tick = 0; tick < 300; ++tick) {
    const double current = noise.next(finest.actuator(), finest.state().position);
    for (HydraulicJoint* joint : {&finest, &fine, &coarse}) {
      joint->step(current, 0.0, kPeriod_s);
    }
    fine_worst_m = std::max(fine_worst_m, std::abs(fine.state().position - finest.state().position));
    coarse_worst_m = std::max(coarse_worst_m, std::abs(coarse.state().position - finest.state().position));
  }
  EXPECT_LT(fine_worst_m, 0.1 * coarse_worst_m);
  EXPECT_LT(coarse_worst_m, 1e-5 * 300 * finest.actuator().stroke);
}

}  // namespace effects_test
}  // namespace farrier::plant
