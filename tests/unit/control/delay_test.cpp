#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "control/design/closed_loop.hpp"
#include "control/design/lqr.hpp"
#include "models.hpp"

namespace farrier::control {
namespace delay_test {

using testing::fc1d;
using testing::hyq;
using testing::kNormalisation;
using testing::sampled;

// Golden digits are of this implementation, FC1D at 50 kg; SpectralRadiusIsTheRateOfASimulatedLoop is their second
// route. Half a unit of the third digit:
constexpr double kThirdDigit = 6e-4;

TEST(LoopDelay, MakesADesignWithoutDelayUnstable) {
  LqrWeights weights;
  weights.integral_factor = 1.0;
  for (const Form form : {Form::kFullState, Form::kCompliant}) {
    const Gains gains = design_lqr(sampled(fc1d(50.0)), weights, kNormalisation, form, 0).value();
    EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 0), form == Form::kFullState ? 0.995 : 0.990,
                kThirdDigit);
    EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 1), 1.003, kThirdDigit);
    EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 2), 1.155, kThirdDigit);
  }
}

TEST(LoopDelay, IsWorseWithTheIntegralFactorInside) {
  const Gains gains = design_lqr(sampled(fc1d(50.0)), {}, kNormalisation, Form::kFullState, 0).value();
  EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 0), 0.995, kThirdDigit);
  EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 1), 1.009, kThirdDigit);
  EXPECT_NEAR(closed_loop_spectral_radius(gains.model, gains, 2), 1.174, kThirdDigit);
}

TEST(LoopDelay, IsMetByADesignThatKnowsOfIt) {
  for (const auto& rig : {fc1d(0.5), fc1d(2.5), fc1d(50.0), fc1d(50.0, 0.0), hyq(2.5), hyq(50.0), hyq(50.0, 100.0)}) {
    for (const Form form : {Form::kFullState, Form::kCompliant}) {
      if (form == Form::kFullState && rig.load_stiffness == 0.0) {
        continue;
      }
      for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
        const auto gains = design_lqr(sampled(rig), {}, kNormalisation, form, delay_ticks);
        ASSERT_TRUE(gains.ok()) << to_string(gains.error());
        EXPECT_LT(closed_loop_spectral_radius(gains.value().model, gains.value(), delay_ticks), 1.0);
        EXPECT_EQ(gains.value().delay_ticks, delay_ticks);
      }
    }
  }
}

TEST(LoopDelay, UsesOnlyAsManyPastInputsAsItHasTicks) {
  const DiscreteModel model = sampled(fc1d(50.0));
  const Gains one = design_lqr(model, {}, kNormalisation, Form::kFullState, 1).value();
  const Gains two = design_lqr(model, {}, kNormalisation, Form::kFullState, 2).value();
  EXPECT_NE(one.delay[0], 0.0);
  EXPECT_EQ(one.delay[1], 0.0);
  EXPECT_NE(two.delay[1], 0.0);
}

/// Largest size of the state of the loop over the ticks [from, from + 300), from a kick of the valve.
double amplitude(const Gains& g, int loop_delay, int from) {
  constexpr int kWindow = 400;  // more than a turn of the slowest pair of poles
  testing::Plant plant(g.model, loop_delay);
  plant.step(1e-3);
  double sum = 0.0;
  double largest = 0.0;
  for (int k = 0; k < from + kWindow; ++k) {
    const Eigen::Vector3d x = plant.state();
    const double u = -g.position * x(0) / kNormalisation.position - g.velocity * x(1) / kNormalisation.velocity -
                     g.force * x(2) / kNormalisation.force + g.integral_factor * g.integral * sum;
    sum -= x(2) / kNormalisation.force;
    plant.step(u * kNormalisation.current_A);
    if (k >= from) {
      largest = std::max(largest, std::abs(x(0)) / kNormalisation.position);
    }
  }
  return largest;
}

// Second route to the poles: the loop simulated from a kick shrinks, or grows, by the spectral radius per tick.
TEST(LoopDelay, SpectralRadiusIsTheRateOfASimulatedLoop) {
  constexpr int kFrom = 1000;  // the faster modes are gone
  constexpr int kTicks = 2500;
  // Where in its turn a window meets a decaying oscillation may change the peak by a factor of two.
  const double kTolerance = std::log(2.0) / kTicks;
  const Gains gains = design_lqr(sampled(fc1d(50.0)), {}, kNormalisation, Form::kFullState, 0).value();
  for (int loop_delay = 0; loop_delay <= kMaxDelayTicks; ++loop_delay) {
    const double growth = amplitude(gains, loop_delay, kFrom + kTicks) / amplitude(gains, loop_delay, kFrom);
    EXPECT_NEAR(std::log(growth) / kTicks, std::log(closed_loop_spectral_radius(gains.model, gains, loop_delay)),
                kTolerance)
        << loop_delay;
  }
}

TEST(ClosedLoopPoles, ShowTheFreePositionOfALoadWithoutSpring) {
  const Gains gains = design_lqr(sampled(hyq(50.0)), {}, kNormalisation, Form::kCompliant, 1).value();
  const auto poles = closed_loop_poles(gains.model, gains, 1);
  int at_one = 0;
  int inside = 0;
  for (const auto& pole : poles) {
    at_one += std::abs(pole - 1.0) < 1e-9;
    inside += std::abs(pole) < 1.0 - 1e-6;
  }
  EXPECT_EQ(at_one, 1);
  EXPECT_EQ(inside, 5);
}

TEST(ClosedLoopPoles, AreNotNumbersForADelayOutOfRange) {
  const Gains gains = design_lqr(sampled(hyq(50.0)), {}, kNormalisation, Form::kCompliant, 1).value();
  EXPECT_TRUE(std::isnan(closed_loop_spectral_radius(gains.model, gains, 3)));
  EXPECT_TRUE(std::isnan(closed_loop_poles(gains.model, gains, -1)[0].real()));
}

}  // namespace delay_test
}  // namespace farrier::control
