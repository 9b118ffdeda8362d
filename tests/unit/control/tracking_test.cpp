#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "control/law/force_controller.hpp"
#include "models.hpp"

namespace farrier::control {
namespace tracking_test {

using testing::fc1d;
using testing::hyq;
using testing::kNormalisation;
using testing::sampled;

constexpr double kAmplitudeN = 160.0;

double step_at_100_ms(double t) { return t >= 0.1 ? kAmplitudeN : 0.0; }

double multisine(double t) {
  double sum = 0.0;
  for (const double frequency_hz : {2.0, 5.0, 10.0}) {
    sum += kAmplitudeN / 3.0 * std::sin(2.0 * std::numbers::pi * frequency_hz * t);
  }
  return sum;
}

/// Root mean square of the force error over the span of the reference, from `from_s` to `to_s`.
double tracking_error(const testing::Rig& rig, Form form, int delay_ticks, double (*reference)(double), double span,
                      double from_s, double to_s) {
  const DiscreteModel model = sampled(rig);
  ForceController controller;
  EXPECT_TRUE(
      controller.set_gains(design_lqr(model, {}, kNormalisation, form, delay_ticks).value(), {0.0, 0.0, 0.0}, 0.0));
  testing::Plant plant(model, delay_ticks);
  double squares = 0.0;
  int count = 0;
  for (int k = 0; k * testing::kPeriodS < to_s; ++k) {
    const double t = k * testing::kPeriodS;
    const Eigen::Vector3d x = plant.state();
    const auto output = controller.step(reference(t), {x(0), x(1), x(2)});
    EXPECT_FALSE(output.saturated);
    plant.step(output.valve_current_A);
    if (t >= from_s) {
      squares += (reference(t) - x(2)) * (reference(t) - x(2));
      ++count;
    }
  }
  return std::sqrt(squares / count) / span;
}

double multisine_error(const testing::Rig& rig, Form form, int delay_ticks) {
  double largest = 0.0;
  for (int k = 0; k < 1000; ++k) {
    largest = std::max(largest, std::abs(multisine(k * testing::kPeriodS)));
  }
  return tracking_error(rig, form, delay_ticks, multisine, 2.0 * largest, 1.0, 3.0);
}

// The setting of Hubacher (2014), Fig. 7.2, on the linear model. Bounds: what was measured, plus a tenth.
TEST(ForceTracking, FollowsTheMultisineOfTheThesis) {
  const double error = multisine_error(fc1d(2.5), Form::kFullState, 0);
  RecordProperty("nrmse", std::to_string(error));
  EXPECT_LT(error, 0.0045);
}

TEST(ForceTracking, FollowsTheMultisineOnALegInStanceAndSwing) {
  EXPECT_LT(multisine_error(hyq(50.0), Form::kCompliant, 0), 0.0042);
  EXPECT_LT(multisine_error(hyq(2.5), Form::kCompliant, 0), 0.0042);
}

TEST(ForceTracking, LosesOneTickOfPhasePerTickOfDelayAndNoMore) {
  // A pure delay of d ms shifts the multisine by its slope: about 0.0040 of its span per tick.
  for (int delay_ticks = 1; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    EXPECT_LT(multisine_error(hyq(50.0), Form::kCompliant, delay_ticks), 0.0042 * (1 + delay_ticks));
    EXPECT_LT(multisine_error(hyq(2.5), Form::kCompliant, delay_ticks), 0.0042 * (1 + delay_ticks));
  }
}

TEST(ForceTracking, StepHasNoSteadyStateError) {
  constexpr double kTolerance = 1e-3;
  EXPECT_LT(tracking_error(fc1d(2.5), Form::kFullState, 0, step_at_100_ms, kAmplitudeN, 2.5, 3.0), kTolerance);
  EXPECT_LT(tracking_error(hyq(2.5), Form::kCompliant, 0, step_at_100_ms, kAmplitudeN, 2.5, 3.0), kTolerance);
}

TEST(ForceTracking, StepErrorIsGoneInFewTicks) {
  // 160 N off for one tick of 500 is 0.045 of the step.
  EXPECT_LT(tracking_error(fc1d(2.5), Form::kFullState, 0, step_at_100_ms, kAmplitudeN, 0.1, 0.6), 0.051);
  EXPECT_LT(tracking_error(hyq(2.5), Form::kCompliant, 0, step_at_100_ms, kAmplitudeN, 0.1, 0.6), 0.051);
  EXPECT_LT(tracking_error(hyq(50.0), Form::kCompliant, 0, step_at_100_ms, kAmplitudeN, 0.1, 0.6), 0.051);
}

}  // namespace tracking_test
}  // namespace farrier::control
