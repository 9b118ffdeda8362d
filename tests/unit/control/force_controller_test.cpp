#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "control/law/force_controller.hpp"
#include "models.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::control {
namespace force_controller_test {

using testing::fc1d;
using testing::hyq;
using testing::kNormalisation;
using testing::sampled;

constexpr double kLimitA = 0.01;
constexpr double kRounding = 1e-15;  // A: a few units in the last place of 10 mA
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Measurement kAtRest{0.0, 0.0, 0.0};

Gains stance(int delay_ticks = 0) {
  return design_lqr(sampled(fc1d(50.0)), {}, kNormalisation, Form::kFullState, delay_ticks).value();
}
Gains swing(int delay_ticks = 0) {
  return design_lqr(sampled(fc1d(2.5)), {}, kNormalisation, Form::kFullState, delay_ticks).value();
}

ForceController controller_with(const Gains& gains) {
  ForceController controller;
  EXPECT_TRUE(controller.set_gains(gains, kAtRest, 0.0));
  return controller;
}

TEST(ForceController, NullsTheValveUntilGainsAreSet) {
  ForceController controller;
  EXPECT_EQ(controller.step(100.0, {0.01, 0.2, 30.0}).valve_current_A, 0.0);
}

TEST(ForceController, SumsTheContributionsOfItsLayout) {
  const Gains g = stance();
  ForceController controller = controller_with(g);
  const Measurement m{0.002, 0.01, 20.0};
  controller.step(40.0, kAtRest);
  const double sum = 40.0 / 5000.0;
  EXPECT_DOUBLE_EQ(controller.integrator(), sum);
  const auto output = controller.step(50.0, m);
  const double expected = g.position * -0.002 / 0.04 + g.velocity * -0.01 / 1.2 + g.force * 30.0 / 5000.0 +
                          6.0 * g.integral * sum + g.feed_forward * 50.0 / 5000.0;
  EXPECT_NEAR(output.valve_current_A, kLimitA * expected, kRounding);
  EXPECT_NEAR(output.position_part_A + output.velocity_part_A + output.force_part_A + output.integral_part_A +
                  output.feed_forward_part_A + output.delay_part_A,
              output.valve_current_A, kRounding);
  EXPECT_FALSE(output.saturated);
}

TEST(ForceController, SubtractsItsPastCurrentsInALoopWithDelay) {
  const Gains g = stance(2);
  ForceController controller = controller_with(g);
  const double older = controller.step(40.0, kAtRest).valve_current_A;
  const double newer = controller.step(20.0, kAtRest).valve_current_A;
  EXPECT_NEAR(controller.step(0.0, kAtRest).delay_part_A, -g.delay[0] * newer - g.delay[1] * older, kRounding);
}

TEST(ForceController, ChangesGainsWithoutABump) {
  for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    ForceController controller = controller_with(swing(delay_ticks));
    const Measurement now{0.001, 0.02, 55.0};
    double last = 0.0;
    for (int k = 0; k < 5; ++k) {
      last = controller.step(60.0, now).valve_current_A;
    }
    ASSERT_LT(std::abs(last), kLimitA);
    ASSERT_TRUE(controller.set_gains(stance(delay_ticks), now, 60.0));
    EXPECT_NEAR(controller.step(60.0, now).valve_current_A, last, kRounding) << delay_ticks;
  }
}

TEST(ForceController, PassesAJumpOfTheReferenceRightAfterAGainChange) {
  ForceController controller = controller_with(swing());
  const double before = controller.step(10.0, kAtRest).valve_current_A;
  const Gains g = stance();
  ASSERT_TRUE(controller.set_gains(g, kAtRest, 10.0));
  const double after = controller.step(60.0, kAtRest).valve_current_A;
  EXPECT_NEAR(after - before, kLimitA * (g.force + g.feed_forward) * 50.0 / 5000.0, kRounding);
}

TEST(ForceController, KeepsItsGainsWhenNewOnesAreNotUsable) {
  ForceController controller = controller_with(stance());
  ForceController untouched = controller;
  Gains broken = swing();
  broken.force = kNaN;
  EXPECT_FALSE(controller.set_gains(broken, kAtRest, 0.0));
  broken = swing();
  broken.integral = 0.0;
  EXPECT_FALSE(controller.set_gains(broken, kAtRest, 0.0));
  EXPECT_FALSE(controller.set_gains(swing(), {kNaN, 0.0, 0.0}, 0.0));
  EXPECT_EQ(controller.step(30.0, kAtRest).valve_current_A, untouched.step(30.0, kAtRest).valve_current_A);
}

TEST(ForceController, BoundsItsOutputAndSaysSo) {
  ForceController controller = controller_with(stance());
  for (const double reference : {1e4, -1e4, 1e300, -1e300}) {
    const auto output = controller.step(reference, kAtRest);
    EXPECT_EQ(output.valve_current_A, reference > 0.0 ? kLimitA : -kLimitA);
    EXPECT_TRUE(output.saturated);
  }
}

TEST(ForceController, DoesNotWindUpUnderLongSaturation) {
  ForceController controller = controller_with(stance());
  for (int k = 0; k < 10000; ++k) {
    ASSERT_TRUE(controller.step(4000.0, kAtRest).saturated);
  }
  EXPECT_EQ(controller.integrator(), 0.0);
  // Once the force has arrived the valve closes within the tick, not after the sum has run down.
  EXPECT_NEAR(controller.step(0.0, kAtRest).valve_current_A, 0.0, kRounding);
}

TEST(ForceController, RunsItsSumDownWhileSaturated) {
  ForceController controller = controller_with(stance());
  for (int k = 0; k < 40; ++k) {
    controller.step(100.0, kAtRest);
  }
  const double charged = controller.integrator();
  ASSERT_GT(charged, 0.0);
  // The velocity part holds the output at the positive limit while the force error is negative.
  const auto output = controller.step(0.0, {0.0, 1.2, 100.0});
  ASSERT_TRUE(output.saturated);
  ASSERT_GT(output.valve_current_A, 0.0);
  EXPECT_LT(controller.integrator(), charged);
}

TEST(ForceController, NullsTheValveOnNonFiniteInputAndKeepsItsSum) {
  ForceController controller = controller_with(stance(1));
  controller.step(50.0, kAtRest);
  const double sum = controller.integrator();
  for (const double bad : {kNaN, HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(controller.step(bad, kAtRest).valve_current_A, 0.0);
    EXPECT_EQ(controller.step(50.0, {bad, 0.0, 0.0}).valve_current_A, 0.0);
    EXPECT_EQ(controller.step(50.0, {0.0, bad, 0.0}).valve_current_A, 0.0);
    EXPECT_EQ(controller.step(50.0, {0.0, 0.0, bad}).valve_current_A, 0.0);
    EXPECT_EQ(controller.integrator(), sum);
  }
  EXPECT_TRUE(std::isfinite(controller.step(50.0, kAtRest).valve_current_A));
}

TEST(ForceController, ResetEmptiesTheSumAndForgetsPastCurrents) {
  ForceController controller = controller_with(stance(2));
  ForceController fresh = controller;
  for (int k = 0; k < 10; ++k) {
    controller.step(80.0, {0.001, 0.1, 20.0});
  }
  controller.reset();
  EXPECT_EQ(controller.step(30.0, kAtRest).valve_current_A, fresh.step(30.0, kAtRest).valve_current_A);
}

TEST(ForceController, StepAndGainChangeDoNotAllocate) {
  const Gains first = stance(2);
  const Gains second = swing(2);
  ForceController controller = controller_with(first);
  const test::AllocationGuard guard;
  for (int k = 0; k < 1000; ++k) {
    controller.step(50.0 * std::sin(0.01 * k), {0.0, 0.001 * k, 20.0});
    controller.set_gains(k % 2 == 0 ? second : first, kAtRest, 0.0);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(ForceController, DesignDoesNotAllocate) {
  const DiscreteModel model = sampled(hyq(50.0));
  const test::AllocationGuard guard;
  const bool ok = design_lqr(model, {}, kNormalisation, Form::kCompliant, 2).ok();
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(ok);
}

}  // namespace force_controller_test
}  // namespace farrier::control
