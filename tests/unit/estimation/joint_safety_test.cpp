// A joint's estimator with invalid settings and samples.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <limits>
#include <string>

#include "joint.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace joint_safety_test {

using namespace testing;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string refusal(const EstimatorParams& params, const JointScales& with = scales()) {
  const LinearModel prior = linear_joint(kSwingMass_kg);
  const auto refused = JointEstimator::create(params, with, prior.a, prior.b);
  return refused ? "" : refused.error().message;
}

template <typename Change>
std::string refusal_when(Change change) {
  EstimatorParams params;
  change(params);
  return refusal(params);
}

TEST(JointEstimator, RefusesSettingsOutOfRangeByName) {
  using P = EstimatorParams;
  EXPECT_EQ(refusal({}), "");
  const auto expect_named = [](const char* name, const std::string& message) {
    EXPECT_NE(message.find(name), std::string::npos) << name << ": '" << message << "'";
  };
  expect_named("operating_point_order", refusal_when([](P& p) { p.operating_point_order = -1; }));
  expect_named("operating_point_order", refusal_when([](P& p) { p.operating_point_order = 5; }));
  expect_named("forgetting_factor", refusal_when([](P& p) { p.forgetting_factor = 1.5; }));
  expect_named("initial_covariance", refusal_when([](P& p) { p.initial_covariance = 0.0; }));
  expect_named("covariance_limit", refusal_when([](P& p) { p.covariance_limit = 1e3; }));
  expect_named("regressor_min", refusal_when([](P& p) { p.regressor_min = -1.0; }));
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    expect_named("full_weight_norm", refusal_when([&](P& p) { p.full_weight_norm = bad; }));
    expect_named("operating_point_time_constant_s",
                 refusal_when([&](P& p) { p.operating_point_time_constant_s = bad; }));
  }
  for (const double bad : {-1e-9, 1.1, kNaN}) {
    expect_named("model_error", refusal_when([&](P& p) { p.model_error = bad; }));
  }
  for (const double bad : {-0.1, 1.0, kNaN}) {
    expect_named("innovation_forgetting", refusal_when([&](P& p) { p.innovation_forgetting = bad; }));
  }
  for (const double bad : {0.0, 1.0, kNaN}) {
    expect_named("stability_limit", refusal_when([&](P& p) { p.stability_limit = bad; }));
  }
  expect_named("blank_ticks", refusal_when([](P& p) { p.blank_ticks = -1; }));
  expect_named("min_samples", refusal_when([](P& p) { p.min_samples = 0; }));
}

TEST(JointEstimator, RefusesScalesOutOfRange) {
  for (const double bad : {0.0, -1.0, kNaN, kInfinity}) {
    JointScales with = scales();
    with.state(1) = bad;
    EXPECT_NE(refusal({}, with), "") << bad;
    with = scales();
    with.current_A = bad;
    EXPECT_NE(refusal({}, with), "") << bad;
    with = scales();
    with.period_s = bad;
    EXPECT_NE(refusal({}, with), "") << bad;
  }
  JointScales with = scales(Eigen::Vector3d(0.0, -1.0, 0.0));
  EXPECT_NE(refusal({}, with), "");
  with = scales();
  with.home_position = kNaN;
  EXPECT_NE(refusal({}, with), "");
  for (const int bad : {-1, 3}) {
    EXPECT_NE(refusal({}, scales(kNoNoise, bad)), "") << bad;
  }
  const LinearModel prior = linear_joint(kSwingMass_kg);
  EXPECT_FALSE(JointEstimator::create({}, scales(), Eigen::Matrix3d::Constant(kNaN), prior.b));
  EXPECT_FALSE(JointEstimator::create({}, scales(), prior.a, Eigen::Vector3d::Constant(kInfinity)));
}

TEST(JointEstimator, LeavesOutASampleThatIsNotFiniteAndSaysSo) {
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e308}) {
    for (int field = 0; field < 4; ++field) {
      JointEstimator estimates = estimator();
      Joint joint(linear_joint(kStanceMass_kg));
      feed(estimates, joint, 1000);
      const ModelEstimate before = estimates.estimate();
      JointSample sample = joint.next();
      (field < 3 ? sample.state(field) : sample.current_A) = bad;
      estimates.take(sample);
      const ModelEstimate after = estimates.estimate();
      EXPECT_TRUE(has(after, EstimateFlag::kSampleRefused));
      EXPECT_EQ(after.a, before.a);
      EXPECT_EQ(after.b, before.b);
      EXPECT_EQ(after.samples, before.samples);
      feed(estimates, joint, 10);
      EXPECT_FALSE(has(estimates.estimate(), EstimateFlag::kSampleRefused));
      EXPECT_GT(estimates.estimate().samples, before.samples);
    }
  }
}

TEST(JointEstimator, LeavesOutASampleOfAPhaseThatDoesNotExist) {
  JointEstimator estimates = estimator();
  Joint joint(linear_joint(kStanceMass_kg));
  feed(estimates, joint, 1000);
  for (const int phase : {-1, 2, 200}) {
    estimates.take(joint.next(phase));
    EXPECT_TRUE(has(estimates.estimate(), EstimateFlag::kSampleRefused)) << phase;
    EXPECT_EQ(estimates.estimate().phase, 0);
  }
}

TEST(JointEstimator, CallsAModelThatCannotBeAJointByItsName) {
  LinearModel backwards = linear_joint(kStanceMass_kg);
  backwards.b = -backwards.b;
  JointEstimator estimates = estimator();
  Joint joint(backwards);
  feed(estimates, joint, 3000);
  const ModelEstimate estimate = estimates.estimate();
  EXPECT_TRUE(has(estimate, EstimateFlag::kNotPhysical));
  EXPECT_EQ(estimate.validity, 0.0);
}

TEST(JointEstimator, MapsAnUnstableJointToAStableOne) {
  LinearModel unstable = linear_joint(kStanceMass_kg);
  unstable.a.bottomRightCorner<2, 2>() *= 1.01 / std::sqrt(unstable.a.bottomRightCorner<2, 2>().determinant());
  EstimatorParams params;
  params.position = false;
  params.operating_point_order = 0;
  JointEstimator estimates = estimator(params);
  Joint joint(unstable);
  feed(estimates, joint, 400);
  const ModelEstimate estimate = estimates.estimate();
  EXPECT_TRUE(has(estimate, EstimateFlag::kMappedToStable));
  const double radius = std::sqrt(estimate.a.bottomRightCorner<2, 2>().determinant());
  EXPECT_NEAR(radius, params.stability_limit, 1e-9);
}

TEST(JointEstimator, StaysFiniteWhateverItIsGiven) {
  for (const bool position : {false, true}) {
    EstimatorParams params;
    params.position = position;
    JointEstimator estimates = estimator(params, scales(kHyqNoise));
    Tick tick = 0;
    for (int k = 0; k < 50'000; ++k) {
      JointSample sample;
      tick += k % 997 == 0 ? 1 + k % 7 : 1;
      sample.tick = k % 4999 == 0 ? kNoTick : tick;
      const double size = std::pow(10.0, k % 61 - 30);
      sample.state = size * normal<3>(9, "state", k);
      sample.current_A = k % 13 == 0 ? 0.0 : size * normal<1>(9, "current", k)(0);
      sample.phase = k / 300 % 2;
      if (k % 211 == 0) {
        sample.state(k % 3) = k % 2 == 0 ? kNaN : 1e308;
      }
      estimates.take(sample);
      const ModelEstimate estimate = estimates.estimate();
      ASSERT_TRUE(estimate.a.allFinite() && estimate.b.allFinite() && estimate.c.allFinite()) << k;
      ASSERT_TRUE(estimate.a_error.allFinite() && estimate.b_error.allFinite()) << k;
      ASSERT_TRUE(estimate.validity >= 0.0 && estimate.validity <= 1.0) << k;
      ASSERT_TRUE(estimate.excitation >= 0.0 && std::isfinite(estimate.excitation)) << k;
    }
    Joint joint(linear_joint(kStanceMass_kg));
    estimates = estimator(params);
    feed(estimates, joint, 3000);
    EXPECT_LT(error(estimates.estimate(), linear_joint(kStanceMass_kg)), 1e-3) << "nothing is shared";
  }
}

TEST(JointEstimator, TakesAndEstimatesWithoutAllocation) {
  JointEstimator estimates = estimator();
  Joint joint(linear_joint(kStanceMass_kg));
  std::vector<JointSample> samples;
  for (int k = 0; k < 500; ++k) {
    samples.push_back(joint.next(k / 100 % 2));
  }
  samples[250].state(2) = kNaN;
  samples[300].tick = kNoTick;
  double sum = 0.0;
  const test::AllocationGuard guard;
  for (const JointSample& sample : samples) {
    estimates.take(sample);
    sum += estimates.estimate().validity;
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_GT(sum, 0.0);
}

}  // namespace joint_safety_test
}  // namespace farrier::estimation
