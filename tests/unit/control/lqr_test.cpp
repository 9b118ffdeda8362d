#include <gtest/gtest.h>

#include <cmath>

#include "control/design/closed_loop.hpp"
#include "control/design/lqr.hpp"
#include "control/numerics/spectrum.hpp"
#include "models.hpp"

namespace farrier::control {
namespace lqr_test {

using testing::fc1d;
using testing::hyq;
using testing::kNormalisation;
using testing::sampled;

Gains designed(const testing::Rig& rig, Form form, int delay_ticks) {
  return design_lqr(sampled(rig), {}, kNormalisation, form, delay_ticks).value();
}

DesignStatus refusal(const DiscreteModel& model, const LqrWeights& weights = {},
                     const Normalisation& normalisation = kNormalisation, Form form = Form::kFullState,
                     int delay_ticks = 0) {
  const auto gains = design_lqr(model, weights, normalisation, form, delay_ticks);
  return gains.ok() ? DesignStatus::kSuccessful : gains.error();
}

// Gains of Hubacher (2014), Figs 7.4 and 7.8, read there as about [0, -4, 8]. The digits are of this implementation
// for u > 0 in (3.51b) and V_pl of 0.6 m of line. SLICOT agrees on the Riccati matrix for these.
TEST(Lqr, GivesTheGainsOfTheThesisAtFiftyKilograms) {
  constexpr double kLastDigit = 6e-4;
  const Gains gains = designed(fc1d(50.0), Form::kFullState, 0);
  EXPECT_NEAR(gains.position, 0.065, kLastDigit);
  EXPECT_NEAR(gains.velocity, -4.469, kLastDigit);
  EXPECT_NEAR(gains.force, 8.552, kLastDigit);
  EXPECT_NEAR(gains.integral, 0.1917, 1e-4);
  EXPECT_EQ(gains.integral_factor, 6.0);
  EXPECT_EQ(gains.delay[0], 0.0);
}

TEST(Lqr, WithoutTheIntegralFactorIsTheOptimumWithTheForceLoopPolesOfTheDesign) {
  LqrWeights weights;
  weights.integral_factor = 1.0;
  constexpr double kLastDigit = 6e-5;
  const DiscreteModel model = sampled(fc1d(50.0));
  const Gains full = design_lqr(model, weights, kNormalisation, Form::kFullState, 0).value();
  EXPECT_NEAR(full.spectral_radius, 0.9949, kLastDigit);
  const Gains compliant = design_lqr(model, weights, kNormalisation, Form::kCompliant, 0).value();
  EXPECT_NEAR(compliant.spectral_radius, 0.9898, kLastDigit);
}

TEST(Lqr, CompliantFormHasNoPositionGainAndTheOtherGainsHardlyChange) {
  const Gains full = designed(fc1d(50.0), Form::kFullState, 0);
  const Gains compliant = designed(fc1d(50.0), Form::kCompliant, 0);
  EXPECT_EQ(compliant.position, 0.0);
  EXPECT_NEAR(compliant.velocity, full.velocity, 0.01 * std::abs(full.velocity));
  EXPECT_NEAR(compliant.force, full.force, 0.01 * full.force);
}

TEST(Lqr, CompliantFormIsStableWithTheLoadSpringsItDoesNotKnowOf) {
  for (const double stiffness : {10.0, 5000.0, 21480.0, 35000.0}) {
    for (const double mass_kg : {0.5, 2.5, 50.0}) {
      const Gains gains = designed(fc1d(mass_kg, stiffness), Form::kCompliant, 0);
      for (const auto& pole : closed_loop_poles(gains.model, gains, 0)) {
        EXPECT_LT(std::abs(pole), 1.0) << stiffness << " N/m, " << mass_kg << " kg";
      }
    }
  }
}

TEST(Lqr, RefusesTheFullStateFormWithoutALoadSpring) {
  for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    for (const auto& rig : {fc1d(50.0, 0.0), hyq(2.5), hyq(50.0)}) {
      EXPECT_EQ(refusal(sampled(rig), {}, kNormalisation, Form::kFullState, delay_ticks),
                DesignStatus::kNotStabilisable);
      EXPECT_EQ(refusal(sampled(rig), {}, kNormalisation, Form::kCompliant, delay_ticks), DesignStatus::kSuccessful);
    }
  }
}

TEST(Lqr, ThresholdOfStabilisabilityLiesFarFromBothCases) {
  const auto distance = [](double stiffness) {
    const DiscreteModel plant = normalise(sampled(fc1d(50.0, stiffness)), kNormalisation);
    Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
    a(0, 3) = -1.0;
    a.bottomRightCorner<3, 3>() = plant.a;
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    b.tail<3>() = plant.b;
    return stabilisability(a, b);
  };
  EXPECT_LT(distance(0.0), 1e-4 * kStabilisabilityThreshold);
  EXPECT_GT(distance(2e4), 1e4 * kStabilisabilityThreshold);
}

TEST(Lqr, RefusesByName) {
  const DiscreteModel model = sampled(fc1d(2.5));
  DiscreteModel broken = model;
  broken.a(1, 2) = NAN;
  EXPECT_EQ(refusal(broken), DesignStatus::kModelNotFinite);
  DiscreteModel no_valve = model;
  no_valve.b.setZero();
  EXPECT_EQ(refusal(no_valve), DesignStatus::kNotStabilisable);
  LqrWeights weights;
  weights.input = 0.0;
  EXPECT_EQ(refusal(model, weights), DesignStatus::kWeightsNotPositiveDefinite);
  weights = {};
  weights.force = -1.0;
  EXPECT_EQ(refusal(model, weights), DesignStatus::kWeightsNotPositiveDefinite);
  weights = {};
  weights.integral_factor = 0.0;
  EXPECT_EQ(refusal(model, weights), DesignStatus::kIntegralFactorOutOfBounds);
  weights = {};
  weights.feed_forward_factor = -1.0;
  EXPECT_EQ(refusal(model, weights), DesignStatus::kWrongOptionForFeedForward);
  EXPECT_EQ(refusal(model, {}, {0.04, 0.0, 5000.0, 0.01}), DesignStatus::kNormalisationOutOfBounds);
  EXPECT_EQ(refusal(model, {}, kNormalisation, Form::kFullState, 3), DesignStatus::kDelayOutOfBounds);
  EXPECT_EQ(refusal(model, {}, kNormalisation, Form::kFullState, -1), DesignStatus::kDelayOutOfBounds);
  const auto continuous = testing::force_model(fc1d(2.5));
  const auto gains = design_lqr(continuous.a, continuous.b, 0.0, {}, kNormalisation, Form::kFullState, 0);
  ASSERT_FALSE(gains.ok());
  EXPECT_EQ(gains.error(), DesignStatus::kWrongSamplingTime);
}

// xi multiplies the integral gain after the optimum is found, so it can make the loop unstable.
TEST(Lqr, RefusesAnIntegralFactorThatMakesTheClosedLoopUnstable) {
  LqrWeights weights;
  weights.integral = 2e4;
  weights.integral_factor = 50.0;
  EXPECT_EQ(refusal(sampled(fc1d(2.5)), weights), DesignStatus::kClosedLoopNotStable);
}

TEST(Lqr, RefusesAnUnweightedIntegrator) {
  LqrWeights weights;
  weights.integral = 0.0;
  EXPECT_NE(refusal(sampled(fc1d(2.5)), weights), DesignStatus::kSuccessful);
}

TEST(Lqr, DesignsFromAContinuousModelAsFromItsSamples) {
  const auto continuous = testing::force_model(fc1d(2.5));
  const auto gains =
      design_lqr(continuous.a, continuous.b, testing::kPeriodS, {}, kNormalisation, Form::kFullState, 1);
  ASSERT_TRUE(gains.ok());
  EXPECT_EQ(gains.value().force, designed(fc1d(2.5), Form::kFullState, 1).force);
}

// At rest with the integrator empty the force must equal the reference.
TEST(Lqr, FeedForwardGivesUnitStaticGainWithoutTheIntegrator) {
  constexpr double kTolerance = 1e-9;  // 0.995^5000 = 1e-11 of the start is left, times a few
  for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
    const Gains g = designed(fc1d(2.5), Form::kFullState, delay_ticks);
    testing::Plant plant(g.model, delay_ticks);
    const double reference = 100.0 / kNormalisation.force;
    double past[2] = {0.0, 0.0};
    for (int k = 0; k < 5000; ++k) {
      const Eigen::Vector3d& x = plant.state();
      const double u = -g.position * x(0) / kNormalisation.position - g.velocity * x(1) / kNormalisation.velocity +
                       g.force * (reference - x(2) / kNormalisation.force) + g.feed_forward * reference -
                       g.delay[0] * past[0] - g.delay[1] * past[1];
      past[1] = past[0];
      past[0] = u;
      plant.step(u * kNormalisation.current_A);
    }
    EXPECT_NEAR(plant.state()(2) / 100.0, 1.0, kTolerance) << delay_ticks;
  }
}

TEST(Lqr, CompliantFeedForwardStaysBoundedForAFrictionlessLoad) {
  for (const double damping : {0.0, 1.0, 100.0}) {
    const auto gains = design_lqr(sampled(hyq(50.0, damping)), {}, kNormalisation, Form::kCompliant, 1);
    if (damping > 0.0) {
      ASSERT_TRUE(gains.ok()) << to_string(gains.error());
      EXPECT_NEAR(gains.value().feed_forward, 0.2, 0.02);
    } else {
      // Without friction the integral of the force is the load's speed: nothing can hold both.
      EXPECT_FALSE(gains.ok());
    }
  }
}

TEST(Lqr, FeedForwardFactorScalesAndSwitchesOff) {
  LqrWeights weights;
  weights.feed_forward_factor = 0.0;
  const DiscreteModel model = sampled(fc1d(2.5));
  EXPECT_EQ(design_lqr(model, weights, kNormalisation, Form::kFullState, 0).value().feed_forward, 0.0);
  weights.feed_forward_factor = 0.5;
  EXPECT_DOUBLE_EQ(design_lqr(model, weights, kNormalisation, Form::kFullState, 0).value().feed_forward,
                   0.5 * designed(fc1d(2.5), Form::kFullState, 0).feed_forward);
}

}  // namespace lqr_test
}  // namespace farrier::control
