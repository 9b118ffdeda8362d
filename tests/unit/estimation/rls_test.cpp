// The estimator against other routes to the same numbers, and against the truth.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimation/rls.hpp"
#include "data.hpp"
#include "textbook/textbook_rls.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace rls_test {

using testing::excited;
using testing::normal;
using testing::Sample;

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kInitial = 1e3;
constexpr double kNoise = 1e-2;

template <int N>
Rls<N> estimator(double forgetting_factor, double initial = kInitial) {
  return Rls<N>::create({forgetting_factor, initial, 1e12, 0.0}).value();
}

template <class Matrix>
double condition(const Matrix& p) {
  const Eigen::VectorXd values = test::symmetric_eigenvalues(p);
  return values.maxCoeff() / values.minCoeff();
}

/// Largest difference of two estimates in one run, over the scale of the parameters.
struct Comparison {
  double difference = 0.0;
  double covariance_difference = 0.0;  // of the last sample, over the largest entry
  double condition = 0.0;              // largest of P
};

template <int N>
Comparison compare(double forgetting_factor, const std::vector<Sample<N>>& samples, double scale) {
  Rls<N> ours = estimator<N>(forgetting_factor);
  textbook::TextbookRls<N> textbook(forgetting_factor, kInitial);
  Comparison result;
  for (const Sample<N>& sample : samples) {
    EXPECT_EQ(ours.update(sample.h, sample.y), RlsStatus::kOk);
    textbook.update(sample.h, sample.y);
    const double difference = (ours.parameters() - textbook.parameters()).cwiseAbs().maxCoeff() / scale;
    result.difference = std::max(result.difference, difference);
    result.condition = std::max(result.condition, condition(ours.covariance()));
  }
  Eigen::Matrix<double, 3 * N, 3 * N> blocks = Eigen::Matrix<double, 3 * N, 3 * N>::Zero();
  for (int row = 0; row < 3; ++row) {
    blocks.template block<N, N>(N * row, N * row) = ours.covariance();
  }
  result.covariance_difference = (blocks - textbook.covariance()).cwiseAbs().maxCoeff() / blocks.cwiseAbs().maxCoeff();
  return result;
}

// A thousand to one is the worst condition of P here (the first samples, P(0) = 1e3): a few hundred eps of it.
TEST(Rls, EqualsTheTextbookOnExcitedData) {
  constexpr double kTolerance = 1e-12;
  for (const double lambda : {0.85, 0.9, 0.97, 0.999}) {
    const Eigen::Matrix<double, 3, 4> theta = normal<3, 4>(11, "theta", 0);
    const Comparison found = compare<4>(lambda, excited<4>(theta, kNoise, 3000, 12), theta.cwiseAbs().maxCoeff());
    EXPECT_LT(found.difference, kTolerance) << "lambda " << lambda << ", cond(P) up to " << found.condition;
    EXPECT_LT(found.covariance_difference, kTolerance) << "lambda " << lambda;
  }
}

TEST(Rls, EqualsTheTextbookWithEverySize) {
  constexpr double kTolerance = 1e-12;
  const auto difference = [](auto size) {
    constexpr int n = decltype(size)::value;
    const Eigen::Matrix<double, 3, n> theta = normal<3, n>(21, "theta", n);
    return compare<n>(0.95, excited<n>(theta, kNoise, 2000, 22), theta.cwiseAbs().maxCoeff()).difference;
  };
  EXPECT_LT(difference(std::integral_constant<int, 3>{}), kTolerance);
  EXPECT_LT(difference(std::integral_constant<int, 5>{}), kTolerance);
}

// A least-squares solution moves by eps cond(R), R = P^-1, under rounding of its data.
TEST(Rls, EqualsTheTextbookOnBadlyExcitedDataAsFarAsTheDataDetermineIt) {
  const Eigen::Matrix<double, 3, 4> theta = normal<3, 4>(31, "theta", 0);
  for (const double spread : {1e-1, 1e-2, 1e-3}) {
    std::vector<Sample<4>> samples;
    for (int k = 0; k < 2000; ++k) {
      const Eigen::Vector4d common = NoiseStream(32, "common", "0").normal(k) * Eigen::Vector4d(1.0, -0.7, 0.4, 1.2);
      const Eigen::Vector4d h = common + spread * normal<4>(32, "regressor", k);
      samples.push_back({h, theta * h + kNoise * normal<3>(32, "noise", k)});
    }
    const Comparison found = compare<4>(0.95, samples, theta.cwiseAbs().maxCoeff());
    EXPECT_GT(found.condition, 1.0 / (spread * spread)) << "the data must be badly excited";
    EXPECT_LT(found.difference, 10.0 * kEps * found.condition) << "spread " << spread;
  }
}

// (6.4), (6.5), and the first covariance as a measurement of theta0 that ages too.
TEST(Rls, SolvesTheWeightedNormalEquations) {
  constexpr double kLambda = 0.96;
  constexpr int kCount = 200;
  const Eigen::Matrix<double, 3, 4> theta = normal<3, 4>(41, "theta", 0);
  const auto samples = excited<4>(theta, kNoise, kCount, 42);
  Rls<4> rls = estimator<4>(kLambda);
  Eigen::Matrix4d information = Eigen::Matrix4d::Identity() / kInitial;
  Eigen::Matrix<double, 4, 3> right = Eigen::Matrix<double, 4, 3>::Zero();
  double weight = 0.0;
  for (const auto& [h, y] : samples) {
    rls.update(h, y);
    information = kLambda * information + h * h.transpose();
    right = kLambda * right + h * y.transpose();
    weight = kLambda * weight + 1.0;
  }
  const Eigen::Matrix<double, 3, 4> batch = (test::inverse(information) * right).transpose();
  const double tolerance = 100.0 * kEps * condition(information);
  EXPECT_LT((rls.parameters() - batch).norm(), tolerance * batch.norm());
  EXPECT_LT((rls.covariance() * information - Eigen::Matrix4d::Identity()).norm(), tolerance);
  EXPECT_DOUBLE_EQ(rls.weight(), weight);
  EXPECT_EQ(rls.samples(), kCount);

  // The residual sum of the fit, measured afresh.
  Eigen::Vector3d squares = std::pow(kLambda, kCount) / kInitial * batch.rowwise().squaredNorm();
  for (int k = 0; k < kCount; ++k) {
    const Eigen::Vector3d e = samples[k].y - batch * samples[k].h;
    squares += std::pow(kLambda, kCount - 1 - k) * e.cwiseAbs2();
  }
  constexpr double kCancellation = 1e-9;  // residuals of 1e-2 beside first errors of 1
  EXPECT_LT((rls.residual_variance() - squares / weight).norm(), kCancellation * squares.norm() / weight);
}

TEST(Rls, ConvergesToANoisySystem) {
  const Eigen::Matrix<double, 3, 4> theta = normal<3, 4>(51, "theta", 0);
  Rls<4> rls = estimator<4>(1.0);
  for (const auto& [h, y] : excited<4>(theta, kNoise, 20000, 52)) {
    rls.update(h, y);
  }
  // Five standard errors noise / sqrt(n).
  EXPECT_LT((rls.parameters() - theta).cwiseAbs().maxCoeff(), 5.0 * kNoise / std::sqrt(20000.0));
  // The variance of a variance of n normal samples is 2/n of its square.
  const Eigen::Array3d ratio = rls.residual_variance().array() / (kNoise * kNoise);
  EXPECT_LT((ratio - 1.0).abs().maxCoeff(), 5.0 * std::sqrt(2.0 / 20000.0));
}

TEST(Rls, FollowsAChangeOfTheSystemWithinItsMemory) {
  const Eigen::Matrix<double, 3, 4> before = normal<3, 4>(61, "theta", 0);
  const Eigen::Matrix<double, 3, 4> after = normal<3, 4>(61, "theta", 1);
  Rls<4> rls = estimator<4>(0.9);
  for (const auto& [h, y] : excited<4>(before, 0.0, 500, 62)) {
    rls.update(h, y);
  }
  const double start = (rls.parameters() - after).norm();
  for (const auto& [h, y] : excited<4>(after, 0.0, 100, 63)) {
    rls.update(h, y);
  }
  // The old samples keep a weight of 0.9^100; an order of magnitude allows for the spread of the excitation.
  EXPECT_LT((rls.parameters() - after).norm(), 10.0 * std::pow(0.9, 100) * start);
}

TEST(Rls, ParameterVarianceIsTheSpreadOfTheEstimate) {
  constexpr int kRuns = 2000;
  constexpr double kFlat = 1e6;  // the first estimate is 1 off: 1/kFlat in a residual sum of 100 kNoise^2
  const Eigen::Matrix<double, 3, 4> theta = normal<3, 4>(71, "theta", 0);
  Eigen::Matrix<double, 3, 4> squares = Eigen::Matrix<double, 3, 4>::Zero();
  Eigen::Matrix<double, 3, 4> claimed = Eigen::Matrix<double, 3, 4>::Zero();
  for (int run = 0; run < kRuns; ++run) {
    Rls<4> rls = estimator<4>(1.0, kFlat);
    for (const auto& [h, y] : excited<4>(theta, kNoise, 100, 72, 100 * run)) {
      rls.update(h, y);
    }
    squares += (rls.parameters() - theta).cwiseAbs2() / kRuns;
    for (int i = 0; i < 12; ++i) {
      claimed(i % 3, i / 3) += rls.parameter_variance(i % 3, i / 3) / kRuns;
    }
  }
  // Four of a hundred samples' worth went into the fit; the rest is the spread of a variance of kRuns runs.
  const double tolerance = 4.0 / 100.0 + 5.0 * std::sqrt(2.0 / kRuns);
  EXPECT_LT((claimed.array() / squares.array() - 1.0).abs().maxCoeff(), tolerance);
}

}  // namespace rls_test
}  // namespace farrier::estimation
