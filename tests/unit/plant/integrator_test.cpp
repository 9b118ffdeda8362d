#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "plant/runge_kutta.hpp"
#include "test_joints.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/plant/reference.hpp"

namespace farrier::plant {
namespace integrator_test {

using test::kPeriod_s;

struct Drive {
  LoadParams load;
  double valve_share;
};

class StatedError : public testing::TestWithParam<Drive> {};

TEST_P(StatedError, BoundsTheTrueErrorOfSteps) {
  // Substeps that graze a void or a port pressure between their stages can err more than stated: seen in 0.2 % of
  // the steps of a stance leg, by up to 6. Everything else is held to its word.
  constexpr double kShareHeld = 0.995;
  constexpr double kWorstFactor = 8.0;
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), GetParam().load);
  const JointEquations equations(joint.actuator(), joint.load());
  const double current_max_A = joint.actuator().valve_current_max_A;
  test::ValveNoise noise(GetParam().valve_share, 0.1 * GetParam().valve_share);
  int judged = 0;
  int held = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    const State s = joint.state();
    const double current = std::clamp(noise.next(joint.actuator(), s.position), -current_max_A, current_max_A);
    const IntegrationState truth =
        test::reference_tick(equations, equations.hold(current, 0.0),
                             IntegrationState{s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa}, kPeriod_s);
    const bool void_before = joint.void_volume_a_m3() + joint.void_volume_b_m3() > 0.0;
    const StepReport report = joint.step(current, 0.0, kPeriod_s);
    if (report.cavitated || void_before) {
      continue;  // the published state does not hold the void the reference would start from
    }
    const State& now = joint.state();
    const double pressure = std::max(std::abs(now.pressure_a_Pa - truth.compression_a_Pa),
                                     std::abs(now.pressure_b_Pa - truth.compression_b_Pa)) /
                            report.error_pressure_Pa;
    const double velocity = std::abs(now.velocity - truth.velocity) / report.error_velocity;
    const double position = std::abs(now.position - truth.position) / report.error_position;
    const double worst = std::max({pressure, velocity, position});
    ASSERT_LT(worst, kWorstFactor) << "tick " << tick;
    ++judged;
    held += worst <= 1.0;
  }
  EXPECT_GT(judged, 700);
  EXPECT_GE(held, kShareHeld * judged);
}

INSTANTIATE_TEST_SUITE_P(Drives, StatedError,
                         testing::Values(Drive{test::swing_load(), 0.2}, Drive{test::swing_load(), 0.5},
                                         Drive{test::stance_load(), 0.2}, Drive{test::stance_load(), 0.5}));

TEST(HydraulicJoint, TighterToleranceBringsTheTrajectoryCloser) {
  const std::vector<double> tolerances{1e-4, 1e-6, 1e-8};
  HydraulicJoint finest = test::joint_at_rest(test::hyq_cylinder(), test::swing_load(), 1e-11);
  std::vector<HydraulicJoint> joints;
  for (const double tolerance : tolerances) {
    joints.push_back(test::joint_at_rest(test::hyq_cylinder(), test::swing_load(), tolerance));
  }
  std::vector<double> worst_Pa(tolerances.size(), 0.0);
  test::ValveNoise noise(0.2, 0.02);
  for (int tick = 0; tick < 300; ++tick) {
    const double current = noise.next(finest.actuator(), finest.state().position);
    finest.step(current, 0.0, kPeriod_s);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i].step(current, 0.0, kPeriod_s);
      worst_Pa[i] = std::max(worst_Pa[i], std::abs(joints[i].state().pressure_a_Pa - finest.state().pressure_a_Pa));
    }
  }
  EXPECT_LT(worst_Pa[1], 0.2 * worst_Pa[0]);
  EXPECT_LT(worst_Pa[2], 0.2 * worst_Pa[1]);
}

TEST(HydraulicJoint, StopsContainThePistonUnderFullSupply) {
  for (const auto& actuator : {test::hyq_cylinder(), test::hyq_rotary_motor(), test::rig_cylinder()}) {
    for (const double direction : {1.0, -1.0}) {
      const bool rotary = actuator.area_a < 1e-5;
      const LoadParams load = rotary ? LoadParams{0.3, 0.1, 0.0, 0.0} : test::swing_load();
      HydraulicJoint joint = test::joint_at_rest(actuator, load);
      int late_bound_hits = 0;
      bool at_stop = false;
      for (int tick = 0; tick < 3000; ++tick) {
        const StepReport report = joint.step(direction * 0.01, 0.0, kPeriod_s);
        at_stop |= report.at_stop;
        late_bound_hits += report.bound_hit && tick >= 1000;
        ASSERT_GT(joint.state().position, -0.02 * actuator.stroke);
        ASSERT_LT(joint.state().position, 1.02 * actuator.stroke);
      }
      EXPECT_TRUE(at_stop);
      EXPECT_EQ(late_bound_hits, 0);
      EXPECT_NEAR(joint.state().velocity, 0.0, 1e-3 * velocity_scale(actuator));
    }
  }
}

TEST(HydraulicJoint, PressuresStayPhysicalUnderViolentValveNoise) {
  for (const auto& load : {test::swing_load(), test::stance_load()}) {
    HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), load);
    test::ValveNoise noise(2.0, 1.0);
    for (int tick = 0; tick < 3000; ++tick) {
      const StepReport report = joint.step(noise.next(joint.actuator(), joint.state().position), 0.0, kPeriod_s);
      const State& s = joint.state();
      ASSERT_GE(std::min(s.pressure_a_Pa, s.pressure_b_Pa), 0.0);
      // The load at full speed stopped by one oil column: sqrt(M / k) v k / A = 90 MPa for 50 kg at 1.2 m/s.
      ASSERT_LT(std::max(s.pressure_a_Pa, s.pressure_b_Pa), 100e6);
      ASSERT_LE(report.substeps, static_cast<int>(2.0 * kPeriod_s / HydraulicJoint::kShortestSubstep_s) + 1);
    }
  }
}

TEST(HydraulicJoint, TreatsNonFiniteInputAsNull) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::stance_load());
  HydraulicJoint null_valve = joint;
  for (const double bad : {kNan, kInfinite, -kInfinite}) {
    EXPECT_TRUE(joint.step(bad, bad, kPeriod_s).input_refused);
    EXPECT_FALSE(null_valve.step(0.0, 0.0, kPeriod_s).input_refused);
    EXPECT_EQ(joint.state().pressure_a_Pa, null_valve.state().pressure_a_Pa);
    EXPECT_TRUE(joint.step(0.001, 0.0, bad).input_refused);
    EXPECT_EQ(joint.state().position, null_valve.state().position);
  }
  EXPECT_TRUE(joint.step(0.0, 1e300, kPeriod_s).input_refused);
  EXPECT_TRUE(std::isfinite(joint.state().velocity));
}

TEST(HydraulicJoint, StepDoesNotAllocate) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  const farrier::test::AllocationGuard guard;
  for (int tick = 0; tick < 100; ++tick) {
    joint.step(tick % 2 == 0 ? 0.01 : -0.004, 50.0, kPeriod_s);
  }
  joint.set_load(test::stance_load());
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace integrator_test
}  // namespace farrier::plant
