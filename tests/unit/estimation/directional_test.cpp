// Forgetting where there is nothing to learn: what blows up and what does not.

#include <gtest/gtest.h>

#include <cmath>

#include "estimation/directional_forgetting.hpp"
#include "estimation/rls.hpp"
#include "data.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace directional_test {

using testing::excited;
using testing::normal;

constexpr double kLambda = 0.9;
constexpr double kStart = 1e3;
constexpr double kThreshold = 0.01;
constexpr DirectionalParams kParams{kLambda, kStart, kThreshold};
constexpr double kRounding = 1e-9;  // of sums of thousands of products whose sizes span 1e6, relative

template <int N>
Eigen::Matrix<double, 3, N> truth() {
  return normal<3, N>(1, "theta", 0);
}

template <class Filter>
Eigen::Vector2d extremes(const Filter& filter) {
  const Eigen::VectorXd values = test::symmetric_eigenvalues(filter.information());
  return {values.minCoeff(), values.maxCoeff()};
}

TEST(Forgetting, WithoutExcitationExponentialBlowsUpAndDirectionalStaysInsideItsBounds) {
  RlsParams unlimited{kLambda, kStart, 1e40, 0.0};
  Rls<4> exponential = Rls<4>::create(unlimited).value();
  auto variable = VariableDirection<4>::create(kParams).value();
  auto subspace = SubspaceOfInformation<4>::create(kParams).value();
  const Eigen::Vector4d h(0.3, 0.6, -0.3, 0.15);  // the same for ever: one direction of four is excited
  constexpr int kSamples = 240;  // beyond 1e16 the rounding of P is as large as what h says, and P is noise
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector3d y = truth<4>() * h;
    exponential.update(h, y);
    ASSERT_EQ(variable.update(h, y), RlsStatus::kOk);
    ASSERT_EQ(subspace.update(h, y), RlsStatus::kOk);
    ASSERT_GE(extremes(variable)(0), (1.0 - kRounding) * variable.information_floor()) << k;
    ASSERT_GE(extremes(subspace)(0), (1.0 - kRounding) * subspace.information_floor()) << k;
    ASSERT_LE(extremes(subspace)(1), (1.0 + kRounding) * subspace.information_ceiling(h.squaredNorm())) << k;
  }
  // Three directions grow by 1 / lambda a sample.
  const double blown_up = 3.0 * kStart * std::pow(1.0 / kLambda, kSamples);
  EXPECT_GT(blown_up, 1e14);
  EXPECT_NEAR(exponential.covariance_trace(), blown_up, 0.1 * blown_up);
  EXPECT_LE(variable.covariance_trace(), 4.0 / variable.information_floor());
  EXPECT_LT(subspace.covariance_trace(), (1.0 + kRounding) * 4.0 * kStart);
}

/// Regressors that make directional forgetting hard: subspaces that come and go, sizes about the threshold, rotations so
/// slow that the excited direction is never an eigenvector.
template <int N>
Eigen::Matrix<double, N, 1> awkward(int k) {
  const auto base = normal<N>(7, "base", k / 50);
  switch (k / 400 % 4) {
    case 0:
      return base;
    case 1:
      return 2.0 * kThreshold * normal<N>(8, "small", k);
    case 2:
      return (base + 0.05 * normal<N>(9, "wobble", k)).normalized();
    default: {
      Eigen::Matrix<double, N, 1> turning = Eigen::Matrix<double, N, 1>::Zero();
      turning(0) = std::cos(1e-3 * k);
      turning(N - 1) = std::sin(1e-3 * k);
      return turning;
    }
  }
}

template <int N>
void hold_bounds() {
  auto variable = VariableDirection<N>::create(kParams).value();
  auto subspace = SubspaceOfInformation<N>::create(kParams).value();
  double largest = 0.0;
  int left_out = 0;
  for (int k = 0; k < 6000; ++k) {
    const auto h = awkward<N>(k);
    largest = std::max(largest, h.squaredNorm());
    ASSERT_EQ(variable.update(h, truth<N>() * h), RlsStatus::kOk) << k;
    left_out += subspace.update(h, truth<N>() * h) == RlsStatus::kRegressorTooSmall ? 1 : 0;
    ASSERT_GE(extremes(variable)(0), (1.0 - kRounding) * variable.information_floor()) << k;
    ASSERT_GE(extremes(subspace)(0), (1.0 - kRounding) * subspace.information_floor()) << k;
    ASSERT_LE(extremes(subspace)(1), (1.0 + kRounding) * subspace.information_ceiling(largest)) << k;
  }
  EXPECT_GT(left_out, 0) << "the threshold is crossed both ways";
  EXPECT_LT((variable.parameters() - truth<N>()).norm(), 1e-6);
  EXPECT_LT((subspace.parameters() - truth<N>()).norm(), 1e-6);
}

TEST(Forgetting, DirectionalBoundsHoldWhateverTheRegressorsDo) {
  hold_bounds<3>();
  hold_bounds<4>();
  hold_bounds<5>();
}

// With a threshold below every share, every direction is forgotten; with one above, none.
TEST(VariableDirection, IsExponentialForgettingWhereEveryDirectionIsExcitedAndNoneWhereNoneIs) {
  for (const auto& [threshold, lambda] : {std::pair{1e-9, kLambda}, std::pair{1e9, 1.0}}) {
    auto variable = VariableDirection<4>::create({kLambda, kStart, threshold}).value();
    Rls<4> rls = Rls<4>::create({lambda, kStart, 1e40, 0.0}).value();
    for (const auto& [h, y] : excited<4>(truth<4>(), 0.1, 300, 2)) {
      variable.update(h, y);
      rls.update(h, y);
      // The floor of threshold 1e-9 is 1e-17: far below.
      ASSERT_LT((variable.parameters() - rls.parameters()).norm(), kRounding * kStart);
      ASSERT_LT((variable.covariance() - rls.covariance()).norm(), kRounding * kStart);
    }
    EXPECT_LT((variable.residual_variance() - rls.residual_variance()).norm(), kRounding * kStart);
  }
}

// P <- P + (1 - lambda) / lambda h h' / (h'R h) before the sample: the form of Cao and Schwartz (2000).
TEST(SubspaceOfInformation, IsDirectionalForgettingOfTheCovarianceForOneRegressor) {
  auto subspace = SubspaceOfInformation<4>::create(kParams).value();
  Eigen::Matrix4d p = kStart * Eigen::Matrix4d::Identity();
  Eigen::Matrix<double, 3, 4> theta = Eigen::Matrix<double, 3, 4>::Zero();
  for (const auto& [h, y] : excited<4>(truth<4>(), 0.1, 200, 3)) {
    subspace.update(h, y);
    p += (1.0 - kLambda) / kLambda / h.dot(test::inverse(p) * h) * h * h.transpose();
    const Eigen::Vector4d gain = p * h / (1.0 + h.dot(p * h));
    theta += (y - theta * h) * gain.transpose();
    p -= gain * (p * h).transpose();
    ASSERT_LT((subspace.parameters() - theta).norm(), kRounding * kStart);
    ASSERT_LT((subspace.covariance() - p).norm(), kRounding * kStart);
  }
}

// SIFt-RLS follows a changed parameter that is excited and keeps those that are not. Parameters are excited one at a
// time, so that the information has no part that concerns two of them.
TEST(SubspaceOfInformation, FollowsWhatIsExcitedAndKeepsWhatIsNot) {
  auto subspace = SubspaceOfInformation<4>::create(kParams).value();
  const auto see = [&](const Eigen::Matrix<double, 3, 4>& theta, int parameter, int k) {
    const Eigen::Vector4d h = (1.0 + 0.5 * std::sin(k)) * Eigen::Vector4d::Unit(parameter);
    subspace.update(h, theta * h);
  };
  for (int k = 0; k < 400; ++k) {
    see(truth<4>(), k % 4, k);
  }
  Eigen::Matrix<double, 3, 4> changed = truth<4>();
  changed.col(0) *= 2.0;
  for (int k = 0; k < 400; ++k) {
    see(changed, 0, k);
  }
  // Each parameter's information is 1 / P_0 = 1e-3 at the start, forgotten by 0.9 in each of 100 samples of 0.25 or
  // more: 1e-3 0.9^100 against 2.5. The first parameter's old information is forgotten by 0.9^400.
  constexpr double kStartLeft = 1e-6;
  EXPECT_LT((subspace.parameters() - changed).norm(), kStartLeft);
}

TEST(Directional, RefusesSettingsOutOfRangeByName) {
  const auto refusal = [](const DirectionalParams& params) {
    const auto made = VariableDirection<4>::create(params);
    const auto also = SubspaceOfInformation<4>::create(params);
    return (made ? "" : made.error().message) + (also ? "" : also.error().message);
  };
  EXPECT_EQ(refusal(kParams), "");
  for (const double bad : {0.0, 1.1, std::nan("")}) {
    EXPECT_NE(refusal({bad, kStart, kThreshold}).find("forgetting_factor"), std::string::npos);
  }
  EXPECT_NE(refusal({kLambda, -1.0, kThreshold}).find("initial_covariance"), std::string::npos);
  for (const double bad : {0.0, 1e21, std::nan("")}) {
    EXPECT_NE(refusal({kLambda, kStart, bad}).find("vdf.excitation_min"), std::string::npos);
    EXPECT_NE(refusal({kLambda, kStart, bad}).find("sift.excitation_min"), std::string::npos);
  }
}

}  // namespace directional_test
}  // namespace farrier::estimation
