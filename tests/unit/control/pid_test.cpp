// Fixed gains on the force error.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "control/law/pid.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/plant/test_joints.hpp"

namespace farrier::control {
namespace pid_test {

using plant::test::hyq_cylinder;
using plant::test::kPeriod_s;

constexpr double kMiddle_m = 0.04;
constexpr Normalisation kNorm{0.04, 1.2, 5000.0, 0.01};

Measurement force(double value) { return {0.0, 0.0, value}; }

TEST(Pid, IsProportionalIntegralAndFilteredDerivativeOfTheError) {
  // A step of the error: k_p e at once, k_i e t by summing, and a derivative that decays by exp(-w T) a tick with the
  // whole area of the step, e.
  const PidGains gains{.proportional = 2.0, .integral_1_s = 10.0, .derivative_s = 1e-3, .derivative_filter_Hz = 100.0};
  Pid pid(gains, kNorm, kPeriod_s);
  EXPECT_EQ(pid.step(0.0, force(0.0)).valve_current_A, 0.0);
  constexpr double kError = 0.05;
  const double keeps = std::exp(-2.0 * std::numbers::pi * 100.0 * kPeriod_s);
  double rate = (1.0 - keeps) * kError / kPeriod_s;
  double area = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double expected = 2.0 * kError + 10.0 * kPeriod_s * kError * i + 1e-3 * rate;
    EXPECT_NEAR(pid.step(kError * kNorm.force, force(0.0)).valve_current_A, kNorm.current_A * expected, 1e-15) << i;
    area += rate * kPeriod_s;
    rate *= keeps;
  }
  EXPECT_NEAR(area, kError, 1e-9);
}

TEST(Pid, HoldsAForceOnALightAndAHeavyLegWithItsDefaults) {
  constexpr double kReference_N = 500.0;
  constexpr double kSettled = 0.1;  // the load slides off at F / d: a ramp of the disturbance leaves a constant error
  for (const plant::LoadParams& load : {plant::LoadParams{2.5, 2500.0}, plant::LoadParams{50.0, 2500.0}}) {
    plant::HydraulicJoint joint = plant::test::joint_at_rest(hyq_cylinder(), load);
    Pid pid({}, kNorm, kPeriod_s);
    double largest = 0.0;
    for (int tick = 0; tick < 100; ++tick) {
      const Measurement m{joint.state().position - kMiddle_m, joint.state().velocity, joint.load_cell_force()};
      joint.step(pid.step(kReference_N, m).valve_current_A, 0.0, kPeriod_s);
      if (tick >= 80) {
        largest = std::max(largest, std::abs(joint.load_cell_force() - kReference_N));
      }
    }
    EXPECT_LT(largest, kSettled * kReference_N) << load.mass << " kg";
  }
}

TEST(Pid, StaysWithinTheValveAndDoesNotWindUp) {
  Pid pid({}, kNorm, kPeriod_s);
  pid.step(1e6, force(0.0));
  const double before = pid.integrator();
  for (int i = 0; i < 1000; ++i) {
    const auto output = pid.step(1e6, force(0.0));
    ASSERT_EQ(output.valve_current_A, kNorm.current_A);
    ASSERT_TRUE(output.saturated);
  }
  EXPECT_EQ(pid.integrator(), before);
  EXPECT_LT(pid.step(-5e3, force(0.0)).valve_current_A, 0.0);
}

TEST(Pid, GivesNullCurrentForATickWithoutNumbersAndForgetsIt) {
  Pid pid({}, kNorm, kPeriod_s);
  Pid undisturbed({}, kNorm, kPeriod_s);
  pid.step(100.0, force(0.0));
  undisturbed.step(100.0, force(0.0));
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(pid.step(bad, force(0.0)).valve_current_A, 0.0);
    EXPECT_EQ(pid.step(100.0, force(bad)).valve_current_A, 0.0);
  }
  EXPECT_EQ(pid.step(120.0, force(10.0)).valve_current_A, undisturbed.step(120.0, force(10.0)).valve_current_A);
}

TEST(Pid, StartsAfreshAfterReset) {
  Pid pid({}, kNorm, kPeriod_s);
  const double first = pid.step(100.0, force(0.0)).valve_current_A;
  pid.step(200.0, force(-50.0));
  pid.reset();
  EXPECT_EQ(pid.integrator(), 0.0);
  EXPECT_EQ(pid.step(100.0, force(0.0)).valve_current_A, first);
}

TEST(Pid, StepDoesNotAllocate) {
  Pid pid({}, kNorm, kPeriod_s);
  const farrier::test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    pid.step(10.0 * i, force(5.0 * i));
  }
  pid.reset();
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace pid_test
}  // namespace farrier::control
