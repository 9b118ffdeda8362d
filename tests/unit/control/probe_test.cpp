#include <gtest/gtest.h>

#include <cmath>

#include "control/law/force_controller.hpp"
#include "models.hpp"

namespace farrier::control {
namespace probe_test {

using testing::fc1d;
using testing::kNormalisation;
using testing::sampled;

constexpr double kLimitA = 0.01;
constexpr double kProbeA = 2e-4;
constexpr double kRounding = 1e-15;  // A: a few units in the last place of 10 mA
constexpr Measurement kAtRest{0.0, 0.0, 0.0};
constexpr Measurement kMoving{0.001, 0.02, 55.0};

Gains heavy(int delay_ticks = 0) {
  return design_lqr(sampled(fc1d(50.0)), {}, kNormalisation, Form::kFullState, delay_ticks).value();
}
Gains light(int delay_ticks = 0) {
  return design_lqr(sampled(fc1d(2.5)), {}, kNormalisation, Form::kFullState, delay_ticks).value();
}

ForceController controller_with(const Gains& gains) {
  ForceController controller;
  EXPECT_TRUE(controller.set_gains(gains, kAtRest, 0.0));
  return controller;
}

TEST(ForceController, AddsTheProbeToItsCommand) {
  ForceController plain = controller_with(heavy());
  ForceController probed = plain;
  for (const double probe_A : {kProbeA, -kProbeA}) {
    const double command = plain.step(60.0, kMoving).valve_current_A;
    EXPECT_NEAR(probed.step(60.0, kMoving, probe_A).valve_current_A, command + probe_A, kRounding);
    EXPECT_EQ(probed.integrator(), plain.integrator());
  }
}

TEST(ForceController, TakesItsProbeBackLikeAnyPastCurrentInALoopWithDelay) {
  const Gains g = heavy(2);
  ForceController plain = controller_with(g);
  ForceController probed = plain;
  plain.step(60.0, kMoving);
  probed.step(60.0, kMoving, kProbeA);
  const double taken_back = probed.step(60.0, kMoving).delay_part_A - plain.step(60.0, kMoving).delay_part_A;
  EXPECT_NEAR(taken_back, -g.delay[0] * kProbeA, kRounding);
}

TEST(ForceController, LimitsCommandAndProbeTogether) {
  ForceController controller = controller_with(heavy());
  const auto output = controller.step(1.0, kAtRest, 2.0 * kLimitA);
  EXPECT_EQ(output.valve_current_A, kLimitA);
  EXPECT_TRUE(output.saturated);
}

TEST(ForceController, NullsTheValveOnAProbeThatIsNotFinite) {
  ForceController controller = controller_with(heavy());
  EXPECT_EQ(controller.step(50.0, kAtRest, HUGE_VAL).valve_current_A, 0.0);
  EXPECT_TRUE(std::isfinite(controller.step(50.0, kAtRest, kProbeA).valve_current_A));
}

TEST(ForceController, ChangesGainsWithoutABumpTheProbeApart) {
  for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    ForceController controller = controller_with(light(delay_ticks));
    double command = 0.0;
    for (int k = 0; k < 6; ++k) {
      const double probe_A = k % 2 == 0 ? kProbeA : -kProbeA;
      command = controller.step(60.0, kMoving, probe_A).valve_current_A - probe_A;
    }
    ASSERT_LT(std::abs(command), kLimitA - kProbeA);
    ASSERT_TRUE(controller.set_gains(heavy(delay_ticks), kMoving, 60.0));
    EXPECT_NEAR(controller.step(60.0, kMoving, kProbeA).valve_current_A, command + kProbeA, kRounding) << delay_ticks;
  }
}

TEST(ForceController, PassesAJumpOfTheReferenceThroughTheNewGainsWhileItProbes) {
  for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    constexpr double kJumpN = 50.0;
    ForceController controller = controller_with(light(delay_ticks));
    const double before = controller.step(10.0, kAtRest, kProbeA).valve_current_A - kProbeA;
    const Gains g = heavy(delay_ticks);
    ASSERT_TRUE(controller.set_gains(g, kAtRest, 10.0));
    const double after = controller.step(10.0 + kJumpN, kAtRest, -kProbeA).valve_current_A + kProbeA;
    EXPECT_NEAR(after - before, kLimitA * (g.force + g.feed_forward) * kJumpN / kNormalisation.force, kRounding);
  }
}

}  // namespace probe_test
}  // namespace farrier::control
