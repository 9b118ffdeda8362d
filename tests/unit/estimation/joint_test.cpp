// Estimates of a joint's estimator and their standard errors.

#include <gtest/gtest.h>

#include <numbers>

#include "estimation/poles.hpp"
#include "joint.hpp"

namespace farrier::estimation {
namespace joint_test {

using namespace testing;

constexpr int kEnough = 5000;  // ten times what 0.998 remembers
// The prior's weight 1e-5, of which 0.998^5000 = 5e-5 remains, over information of 1e-6 at least, for a prior that is
// off by 0.3; and the washout's start, 5e-4 of it, forgotten as far.
constexpr double kExact = 1e-3;

EstimatorParams with(bool position, bool bias) {
  EstimatorParams params;
  params.position = position;
  params.bias = bias;
  return params;
}

double pole_error(const ModelEstimate& estimate, const LinearModel& truth) {
  const auto poles_of = [](const Eigen::Matrix3d& a) { return poles<2>(Eigen::Matrix2d(a.bottomRightCorner<2, 2>())); };
  return pole_distance<2>(poles_of(estimate.a), poles_of(truth.a));
}

TEST(JointEstimator, RecoversALinearJointWhateverIsInTheRegressor) {
  for (const bool bias : {false, true}) {
    for (const bool position : {false, true}) {
      const LinearModel truth = linear_joint(kStanceMass_kg, position ? 2e4 : 0.0);
      EstimatorParams exact = with(position, bias);
      exact.model_error = 0.0;
      JointEstimator estimates = estimator(exact);
      Joint joint(truth);
      feed(estimates, joint, kEnough);
      const ModelEstimate estimate = estimates.estimate();
      EXPECT_LT(error(estimate, truth, position), kExact) << "position " << position << ", bias " << bias;
      EXPECT_GT(estimate.validity, 0.99);
      // Nothing excites a constant that is zero: its covariance may stand at its bound.
      EXPECT_EQ(estimate.flags & ~static_cast<std::uint32_t>(EstimateFlag::kForgettingAtLimit), 0u);
      EXPECT_EQ(estimate.a.row(0), Eigen::RowVector3d(1.0, kPeriod_s, 0.0));
      EXPECT_EQ(estimate.b(0), 0.0);
    }
  }
}

TEST(JointEstimator, KnowsAPriorAndAnEstimateByTheSameUnits) {
  const LinearModel prior = linear_joint(kSwingMass_kg);
  const ModelEstimate estimate = estimator().estimate();
  EXPECT_LT(error(estimate, prior), 1e-15);
  EXPECT_TRUE(has(estimate, EstimateFlag::kNotYetSet));
  EXPECT_EQ(estimate.validity, 0.0);
}

// A leg's share of the weight: 2 kN that come and go with the stride.
ModelEstimate under_weight(int order) {
  EstimatorParams params = with(false, true);
  params.operating_point_order = order;
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kStanceMass_kg));
  constexpr double kWeight_N = 2000.0, kStride_Hz = 1.4;
  for (int k = 0; k < kEnough; ++k) {
    const double angle = 2.0 * std::numbers::pi * kStride_Hz * kPeriod_s * k;
    estimates.take(joint.next(0, kWeight_N * std::sin(angle), kStanceMass_kg));
  }
  return estimates.estimate();
}

TEST(JointEstimator, IsNotMisledByAWeightThatComesAndGoes) {
  const LinearModel truth = linear_joint(kStanceMass_kg);
  const ModelEstimate washed = under_weight(EstimatorParams{}.operating_point_order);
  EXPECT_LT(error(washed, truth), kExact);
  EXPECT_GT(washed.validity, 0.99);
  const ModelEstimate plain = under_weight(0);
  EXPECT_GT(error(plain, truth), 100.0 * kExact) << "the bias alone does not follow it";
}

// The loop feeds the noise of the force back into the input.
ModelEstimate with_noise(bool state_filter, std::uint64_t seed) {
  JointEstimator estimates = estimator(with(false, true), scales(state_filter ? kHyqNoise : kNoNoise));
  Joint joint(linear_joint(kStanceMass_kg), seed);
  joint.measured_with(kHyqNoise).closed_with(5e-7);
  feed(estimates, joint, kEnough);
  return estimates.estimate();
}

TEST(JointEstimator, IsLessBiasedByNoiseThatTheLoopFeedsBackThanWithoutItsStateFilter) {
  const LinearModel truth = linear_joint(kStanceMass_kg);
  constexpr int kSeeds = 5;
  double filtered = 0.0, unfiltered = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const ModelEstimate estimate = with_noise(true, seed);
    filtered += pole_error(estimate, truth) / kSeeds;
    unfiltered += pole_error(with_noise(false, seed), truth) / kSeeds;
    EXPECT_NEAR(estimate.b(2) / truth.b(2), 1.0, 0.05);
    EXPECT_GT(estimate.validity, 0.5) << "it is of use";
  }
  // Pole distance that the update logic takes for a change.
  constexpr double kPoleDistance = 0.1;
  EXPECT_LT(filtered, kPoleDistance);
  EXPECT_GT(unfiltered, 5.0 * kPoleDistance);
}

TEST(JointEstimator, SaysHowUncertainNoiseMakesIt) {
  const LinearModel truth = linear_joint(kStanceMass_kg);
  constexpr int kSeeds = 10;
  int within = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const ModelEstimate estimate = with_noise(true, seed);
    EXPECT_GT(estimate.b_error(2), 0.0);
    EXPECT_EQ(estimate.b_error(0), 0.0) << "known, not estimated";
    within += std::abs(estimate.b(2) - truth.b(2)) < 3.0 * estimate.b_error(2) ? 1 : 0;
  }
  EXPECT_GE(within, 9) << "of " << kSeeds << " within three standard errors";
}

TEST(JointEstimator, IsLessSureOfTheValveWhenForcesDoWhatNoiseCannotExplain) {
  const auto relative_error = [](double told_noise) {
    EstimatorParams exact = with(false, true);
    exact.model_error = 0.0;
    JointEstimator estimates = estimator(exact, scales(told_noise * kHyqNoise));
    Joint joint(linear_joint(kStanceMass_kg));
    joint.measured_with(kHyqNoise);
    feed(estimates, joint, kEnough);
    const ModelEstimate estimate = estimates.estimate();
    return estimate.b_error(2) / estimate.b(2);
  };
  constexpr double kTimesTheNoise = 20.0;
  EXPECT_LT(relative_error(1.0), kMisfitError);
  // The force's own noise is told too small as well, so the misfit is about as many times what is explained.
  EXPECT_GT(relative_error(1.0 / kTimesTheNoise), 0.5 * kMisfitError * (kTimesTheNoise - kMisfitFree));
}

TEST(JointEstimator, MeasuresMisfitAgainstTheErrorOfTheModelWhereSensorsAreGood) {
  const auto misfit = [](double model_error) {
    EstimatorParams params = with(false, true);
    params.model_error = model_error;
    JointEstimator estimates = estimator(params, scales(0.01 * kHyqNoise));
    Joint joint(linear_joint(kStanceMass_kg));
    joint.measured_with(kHyqNoise);  // stands for what the model leaves out
    feed(estimates, joint, kEnough);
    return estimates.estimate();
  };
  const auto flagged = [](const ModelEstimate& estimate) {
    return (estimate.flags & static_cast<std::uint32_t>(EstimateFlag::kMisfit)) != 0;
  };
  EXPECT_TRUE(flagged(misfit(0.0)));
  EXPECT_FALSE(flagged(misfit(1e-3)));
  EXPECT_GT(misfit(1e-3).b_error(2), 0.0);
  EXPECT_LT(misfit(1e-3).validity, misfit(1e-4).validity) << "an error of the model is doubt";
}

TEST(JointEstimator, RecoversTheSameJointThroughADelay) {
  const LinearModel truth = linear_joint(kStanceMass_kg);
  for (const int delay_ticks : {0, 1, 2}) {
    JointEstimator knows = estimator(with(false, true), scales(kNoNoise, delay_ticks));
    JointEstimator does_not = estimator(with(false, true), scales(kNoNoise, (delay_ticks + 1) % 3));
    Joint joint(truth);
    joint.commanded_late(delay_ticks);
    for (int k = 0; k < kEnough; ++k) {
      const JointSample sample = joint.next();
      knows.take(sample);
      does_not.take(sample);
    }
    EXPECT_LT(error(knows.estimate(), truth), kExact) << delay_ticks;
    EXPECT_GT(error(does_not.estimate(), truth), 100.0 * kExact) << delay_ticks;
  }
}

TEST(JointEstimator, FollowsALoadThatChangesUnannounced) {
  EstimatorParams params = with(false, true);
  params.forgetting_factor = 0.98;
  JointEstimator estimates = estimator(params);
  Joint joint(linear_joint(kSwingMass_kg));
  feed(estimates, joint, 1000);
  EXPECT_LT(error(estimates.estimate(), linear_joint(kSwingMass_kg)), kExact);
  joint.becomes(linear_joint(kStanceMass_kg));
  feed(estimates, joint, 1000);
  EXPECT_LT(error(estimates.estimate(), linear_joint(kStanceMass_kg)), kExact);
}

}  // namespace joint_test
}  // namespace farrier::estimation
