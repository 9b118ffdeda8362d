// Each method of regression against its equations, by a second route.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

#include "estimation/adaptive_forgetting.hpp"
#include "estimation/instrumental_variable.hpp"
#include "estimation/random_walk.hpp"
#include "estimation/rls.hpp"
#include "data.hpp"

namespace farrier::estimation {
namespace methods_test {

using testing::excited;
using testing::normal;
using Theta = Eigen::Matrix<double, 3, 4>;

constexpr double kStart = 1e3;
constexpr double kLimit = 1e9;
constexpr double kRounding = 1e-9;  // of a few hundred updates with entries up to kStart, relative

Theta truth() { return normal<3, 4>(1, "theta", 0); }

TEST(AdaptiveForgetting, ForgetsAsTheEquationsSay) {
  constexpr AdaptiveForgettingParams kParams{.forgetting_min = 0.9, .noise_factor = 4.0, .error_memory = 0.7};
  const Eigen::Vector3d noise_variance(1e-4, 1e-2, 0.0);
  auto adaptive = AdaptiveForgetting<4>::create(kParams, kStart, kLimit, noise_variance).value();
  Eigen::Vector3d power = Eigen::Vector3d::Zero();
  int between = 0;
  for (const auto& [h, y] : excited<4>(truth(), 0.05, 200, 2)) {
    const Eigen::Vector3d e = y - adaptive.parameters() * h;
    ASSERT_EQ(adaptive.update(h, y), RlsStatus::kOk);
    for (int row = 0; row < 3; ++row) {
      const double floor = 4.0 * noise_variance(row);
      const double beyond = std::max(std::abs(e(row)) - std::sqrt(floor), 0.0);      // (9.1)
      power(row) = 0.7 * power(row) + 0.3 * beyond * beyond;                         // (9.2)
      const double lambda = 1.0 - 2.0 * power(row) / (12.0 * (power(row) + floor));  // (9.3), M = 12
      EXPECT_NEAR(adaptive.forgetting()(row), std::clamp(lambda, 0.9, 1.0), 1e-12);
      between += lambda > 0.9 && lambda < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(between, 50) << "neither bound hides the equation";
}

TEST(AdaptiveForgetting, ForgetsInTheRowThatChangedAndOnlyThere) {
  const Eigen::Vector3d noise_variance = Eigen::Vector3d::Constant(1e-4);
  auto adaptive = AdaptiveForgetting<4>::create({}, kStart, kLimit, noise_variance).value();
  for (const auto& [h, y] : excited<4>(truth(), 1e-3, 300, 3)) {
    adaptive.update(h, y);
  }
  // The start's errors leave in (9.2) 0.9^300 = 2e-14 of errors of 10, over 4 sigma_v^2 = 4e-4.
  constexpr double kLeft = 1e-8;
  EXPECT_LT((adaptive.forgetting() - Eigen::Vector3d::Ones()).norm(), kLeft) << "a tenth of the noise allowed for";
  Theta changed = truth();
  changed.row(1) *= 3.0;
  Eigen::Vector3d least = Eigen::Vector3d::Ones();
  for (const auto& [h, y] : excited<4>(changed, 1e-3, 200, 3, 300)) {
    adaptive.update(h, y);
    least = least.cwiseMin(adaptive.forgetting());
  }
  EXPECT_LT((least - Eigen::Vector3d(1.0, 1.0 - 2.0 / 12.0, 1.0)).norm(), 1e-3) << "(9.3) with a large error";
  // Errors end below 2 sigma_v, from where nothing is forgotten: what is left shows as less than that.
  EXPECT_LT((adaptive.parameters() - changed).norm(), 3.0 * 2.0 * std::sqrt(1e-4));
}

TEST(AdaptiveForgetting, IsLeastSquaresWhereNothingIsForgotten) {
  auto adaptive =
      AdaptiveForgetting<4>::create({.forgetting_min = 1.0}, kStart, kLimit, Eigen::Vector3d::Zero()).value();
  Rls<4> rls = Rls<4>::create({1.0, kStart, kLimit, 0.0}).value();
  for (const auto& [h, y] : excited<4>(truth(), 0.1, 300, 4)) {
    adaptive.update(h, y);
    rls.update(h, y);
  }
  EXPECT_LT((adaptive.parameters() - rls.parameters()).norm(), kRounding);
  for (int row = 0; row < 3; ++row) {
    EXPECT_LT((adaptive.covariance(row) - rls.covariance()).norm(), kRounding);
  }
  EXPECT_LT((adaptive.residual_variance() - rls.residual_variance()).norm(), kRounding);
}

TEST(AdaptiveForgetting, WeighsItsNoiseWithTheSample) {
  constexpr double kWeight = 1e-3;
  const Eigen::Vector3d noise_variance = Eigen::Vector3d::Constant(1e-2);
  auto plain = AdaptiveForgetting<4>::create({}, kStart, kLimit, noise_variance).value();
  // Information in proportion to the samples' squares: the same problem in other units.
  auto weighted =
      AdaptiveForgetting<4>::create({}, kStart / kWeight / kWeight, kLimit / kWeight / kWeight, noise_variance).value();
  for (const auto& [h, y] : excited<4>(truth(), 0.2, 300, 4)) {
    plain.update(h, y);
    weighted.update(kWeight * h, kWeight * y, kWeight);
    ASSERT_LT((plain.forgetting() - weighted.forgetting()).norm(), kRounding);
  }
  EXPECT_LT((plain.parameters() - weighted.parameters()).norm(), kRounding);
}

// (B.17) with the 12 x 12 covariance of the stacked parameters, measurement noise of each row its own and drift in
// proportion to it, which is what the shared covariance means.
TEST(RandomWalk, IsTheKalmanFilterOfTheStackedParameters) {
  constexpr double kDrift = 0.02;
  auto walk = RandomWalk<4>::create({.parameter_drift = kDrift}, kStart, kLimit).value();
  const Eigen::Vector3d noise(0.01, 1.0, 30.0);
  Eigen::Matrix<double, 12, 12> p = Eigen::Matrix<double, 12, 12>::Zero();
  Eigen::Matrix<double, 12, 12> drift = p;
  for (int row = 0; row < 3; ++row) {
    p.block<4, 4>(4 * row, 4 * row) = kStart * noise(row) * Eigen::Matrix4d::Identity();
    drift.block<4, 4>(4 * row, 4 * row) = kDrift * noise(row) * Eigen::Matrix4d::Identity();
  }
  Eigen::Matrix<double, 12, 1> stacked = Eigen::Matrix<double, 12, 1>::Zero();
  for (const auto& [h, y] : excited<4>(truth(), 0.1, 200, 5)) {
    ASSERT_EQ(walk.update(h, y), RlsStatus::kOk);
    Eigen::Matrix<double, 3, 12> wide = Eigen::Matrix<double, 3, 12>::Zero();
    for (int row = 0; row < 3; ++row) {
      wide.block<1, 4>(row, 4 * row) = h.transpose();
    }
    const Eigen::Matrix3d s = Eigen::Matrix3d(noise.asDiagonal()) + wide * p * wide.transpose();
    const Eigen::Matrix<double, 12, 3> gain = p * wide.transpose() * s.inverse();
    stacked += gain * (y - wide * stacked);
    p = (p - gain * wide * p + drift).eval();
    for (int row = 0; row < 3; ++row) {
      ASSERT_LT((walk.parameters().row(row).transpose() - stacked.segment<4>(4 * row)).norm(), kRounding * kStart);
      ASSERT_LT((noise(row) * walk.covariance(row) - p.block<4, 4>(4 * row, 4 * row)).norm(),
                kRounding * kStart * noise(row));
    }
  }
}

TEST(RandomWalk, DriftsNoFurtherThanItsLimitAndSaysSo) {
  auto walk = RandomWalk<4>::create({.parameter_drift = 1.0}, kStart, 5.0 * kStart).value();
  int limited = 0;
  for (int k = 0; k < 2000; ++k) {
    walk.update(Eigen::Vector4d::Zero(), Eigen::Vector3d::Zero());
    ASSERT_LE(walk.covariance_trace(), 5.0 * kStart);
    limited += walk.forgetting_limited() ? 1 : 0;
  }
  // 4 a sample from 4 kStart on
  EXPECT_EQ(limited, 2000 - 250);
}

TEST(RandomWalk, IsLeastSquaresWhereNothingDrifts) {
  auto walk = RandomWalk<4>::create({.parameter_drift = 0.0}, kStart, kLimit).value();
  Rls<4> rls = Rls<4>::create({1.0, kStart, kLimit, 0.0}).value();
  for (const auto& [h, y] : excited<4>(truth(), 0.1, 300, 6)) {
    walk.update(h, y);
    rls.update(h, y);
  }
  EXPECT_LT((walk.parameters() - rls.parameters()).norm(), kRounding);
  EXPECT_LT((walk.covariance() - rls.covariance()).norm(), kRounding);
}

TEST(InstrumentalVariable, IsLeastSquaresWithTheRegressorForItsInstrument) {
  constexpr RlsParams kParams{0.95, kStart, kLimit, 0.0};
  auto instrumental = InstrumentalVariable<4>::create(kParams).value();
  Rls<4> rls = Rls<4>::create(kParams).value();
  for (const auto& [h, y] : excited<4>(truth(), 0.1, 300, 7)) {
    ASSERT_EQ(instrumental.update(h, y, h), RlsStatus::kOk);
    rls.update(h, y);
    ASSERT_FALSE(instrumental.instrument_refused());
  }
  EXPECT_LT((instrumental.parameters() - rls.parameters()).norm(), kRounding);
  EXPECT_LT((instrumental.covariance() - rls.covariance()).norm(), kRounding);
  EXPECT_LT((instrumental.residual_variance() - rls.residual_variance()).norm(), kRounding);
}

// Noise in the regressor takes sigma^2 / (1 + sigma^2) off every parameter of least squares: 0.2 with sigma = 0.5.
TEST(InstrumentalVariable, HasNoBiasWhereTheRegressorIsNoisy) {
  constexpr RlsParams kParams{1.0, kStart, kLimit, 0.0};
  constexpr double kNoise = 0.5;
  constexpr int kSamples = 20000;
  auto instrumental = InstrumentalVariable<4>::create(kParams).value();
  Rls<4> rls = Rls<4>::create(kParams).value();
  int refused = 0;
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector4d clean = normal<4>(8, "clean", k);
    const Eigen::Vector4d h = clean + kNoise * normal<4>(8, "noise", k);
    instrumental.update(h, truth() * clean, clean);
    refused += instrumental.instrument_refused() ? 1 : 0;
    rls.update(h, truth() * clean);
  }
  const double bias = (rls.parameters() - truth()).norm() / truth().norm();
  EXPECT_NEAR(bias, 0.2, 0.02);
  // Errors of Theta h's noise: |Theta| sigma / sqrt(n) an entry, relative sigma sqrt(4 / n) = 0.007; refused samples,
  // some of them at the start, are least squares and keep its bias in their share.
  EXPECT_LT((instrumental.parameters() - truth()).norm() / truth().norm(), 0.03 + 0.2 * refused / kSamples);
  EXPECT_LT(refused, kSamples / 10);
}

TEST(InstrumentalVariable, RejectsAnInvalidInstrumentAndTakesTheSampleAllTheSame) {
  auto instrumental = InstrumentalVariable<4>::create({0.95, kStart, kLimit, 0.0}).value();
  Rls<4> rls = Rls<4>::create({0.95, kStart, kLimit, 0.0}).value();
  const double kNaN = std::nan("");
  int k = 0;
  for (const auto& [h, y] : excited<4>(truth(), 0.1, 100, 9)) {
    const Eigen::Vector4d bad = k % 3 == 0   ? Eigen::Vector4d::Constant(kNaN)
                                : k % 3 == 1 ? Eigen::Vector4d(-h)
                                             : 100.0 * h;
    ASSERT_EQ(instrumental.update(h, y, bad), RlsStatus::kOk);
    EXPECT_TRUE(instrumental.instrument_refused());
    rls.update(h, y);
    ++k;
  }
  EXPECT_LT((instrumental.parameters() - rls.parameters()).norm(), kRounding);
}

TEST(Methods, RefuseSettingsOutOfRangeByName) {
  const auto expect_named = [](const char* name, const auto& made) {
    ASSERT_FALSE(made.ok()) << name;
    EXPECT_NE(made.error().message.find(name), std::string::npos) << made.error().message;
  };
  const Eigen::Vector3d noise = Eigen::Vector3d::Ones();
  const double nan = std::nan("");
  for (const double bad : {0.0, 1.1, nan}) {
    expect_named("aff.forgetting_min", AdaptiveForgetting<4>::create({.forgetting_min = bad}, kStart, kLimit, noise));
  }
  for (const double bad : {-1.0, nan}) {
    expect_named("aff.noise_factor", AdaptiveForgetting<4>::create({.noise_factor = bad}, kStart, kLimit, noise));
    expect_named("aff.error_memory", AdaptiveForgetting<4>::create({.error_memory = bad}, kStart, kLimit, noise));
    expect_named("noise", AdaptiveForgetting<4>::create({}, kStart, kLimit, bad * noise));
    expect_named("kalman.parameter_drift", RandomWalk<4>::create({.parameter_drift = bad}, kStart, kLimit));
    expect_named("initial_covariance", RandomWalk<4>::create({}, bad, kLimit));
    expect_named("first estimate", RandomWalk<4>::create({}, kStart, kLimit, Theta::Constant(nan)));
    expect_named("covariance_limit", InstrumentalVariable<4>::create({0.9, kStart, bad, 0.0}));
  }
  expect_named("covariance_limit", AdaptiveForgetting<4>::create({}, kStart, kStart, noise));
  expect_named("regressor_min", InstrumentalVariable<4>::create({0.9, kStart, kLimit, 1.0}));
}

}  // namespace methods_test
}  // namespace farrier::estimation
