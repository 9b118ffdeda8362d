// The estimator with samples that are invalid or hold no information.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "estimation/rls.hpp"
#include "data.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace rls_safety_test {

using testing::excited;
using testing::normal;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr RlsParams kParams{0.9, 1e3, 1e6, 1e-6};
constexpr double kRounding = 1e-12;  // of a sum of ten products, relative

Eigen::Matrix<double, 3, 4> truth() { return normal<3, 4>(1, "theta", 0); }

Rls<4> settled(const RlsParams& params = kParams) {
  Rls<4> rls = Rls<4>::create(params).value();
  for (const auto& [h, y] : excited<4>(truth(), 1e-2, 300, 2)) {
    rls.update(h, y);
  }
  return rls;
}

void expect_same(const Rls<4>& a, const Rls<4>& b) {
  EXPECT_EQ(a.parameters(), b.parameters());
  EXPECT_EQ(a.covariance(), b.covariance());
  EXPECT_EQ(a.residual_variance(), b.residual_variance());
  EXPECT_EQ(a.weight(), b.weight());
  EXPECT_EQ(a.samples(), b.samples());
}

TEST(Rls, RefusesSettingsOutOfRangeByName) {
  const auto refusal = [](const RlsParams& params) {
    const auto rls = Rls<4>::create(params);
    return rls.ok() ? std::string() : rls.error().message;
  };
  EXPECT_EQ(refusal(kParams), "");
  for (const double bad : {0.0, -0.5, 1.0000001, kNaN}) {
    EXPECT_NE(refusal({bad, 1e3, 1e6, 0.0}).find("forgetting_factor"), std::string::npos) << bad;
  }
  for (const double bad : {0.0, -1.0, kInfinity, kNaN}) {
    EXPECT_NE(refusal({0.9, bad, 1e6, 0.0}).find("initial_covariance"), std::string::npos) << bad;
  }
  for (const double bad : {3.9e3, kInfinity, kNaN}) {
    EXPECT_NE(refusal({0.9, 1e3, bad, 0.0}).find("covariance_limit"), std::string::npos) << bad;
  }
  for (const double bad : {-1e-9, kInfinity, kNaN}) {
    EXPECT_NE(refusal({0.9, 1e3, 1e6, bad}).find("regressor_min"), std::string::npos) << bad;
  }
  EXPECT_FALSE(Rls<4>::create(kParams, Eigen::Matrix<double, 3, 4>::Constant(kNaN)).ok());
}

TEST(Rls, HoldsEstimateWithoutExcitation) {
  Rls<4> rls = settled();
  const Rls<4> before = rls;
  for (int k = 0; k < 10000; ++k) {
    EXPECT_EQ(rls.update(1e-7 * normal<4>(3, "regressor", k), normal<3>(3, "y", k)), RlsStatus::kRegressorTooSmall);
  }
  expect_same(rls, before);
}

// (6.24): without a threshold the covariance grows by 1/lambda a sample, as far as the limit.
TEST(Rls, BoundsItsCovarianceWithoutExcitation) {
  RlsParams params = kParams;
  params.regressor_min = 0.0;
  for (const Eigen::Vector4d& h : {Eigen::Vector4d(0.0, 0.0, 0.0, 0.0), Eigen::Vector4d(1.0, 2.0, -1.0, 0.5)}) {
    Rls<4> rls = settled(params);
    const auto before = rls.parameters();
    for (int k = 0; k < 20000; ++k) {
      EXPECT_EQ(rls.update(h, before * h), RlsStatus::kOk);
      ASSERT_LE(rls.covariance_trace(), params.covariance_limit);
    }
    EXPECT_GT(rls.covariance_trace(), 0.9 * kParams.forgetting_factor * params.covariance_limit);
    EXPECT_NEAR(rls.covariance_trace(), rls.covariance().trace(), kRounding * params.covariance_limit);
    EXPECT_LT((rls.parameters() - before).norm(), 1e-9 * before.norm()) << "the samples agree with the estimate";
  }
}

TEST(Rls, ChangesNothingOnASampleThatIsNotFinite) {
  const Eigen::Vector4d h(0.3, -0.2, 0.5, 0.1);
  const Eigen::Vector3d y(0.1, 0.2, -0.3);
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e41, 1e200, -1e308}) {
    Rls<4> rls = settled();
    const Rls<4> before = rls;
    for (int i = 0; i < 4; ++i) {
      Eigen::Vector4d broken = h;
      broken(i) = bad;
      EXPECT_EQ(rls.update(broken, y), RlsStatus::kNotFinite) << bad;
    }
    for (int i = 0; i < 3; ++i) {
      Eigen::Vector3d broken = y;
      broken(i) = bad;
      EXPECT_EQ(rls.update(h, broken), RlsStatus::kNotFinite) << bad;
      EXPECT_EQ(rls.update(Eigen::Vector4d::Zero(), broken), RlsStatus::kNotFinite) << bad;
    }
    expect_same(rls, before);
    EXPECT_EQ(rls.update(h, y), RlsStatus::kOk);
  }
}

/// Zeros, constants, tiny, huge and collinear regressors, with measurements to match or not.
Eigen::Vector4d nasty_regressor(int k) {
  const Eigen::Vector4d white = normal<4>(5, "regressor", k / 10 % 977);
  switch (k / 500 % 7) {
    case 0:
      return Eigen::Vector4d::Zero();
    case 1:
      return Eigen::Vector4d(1.0, -2.0, 3.0, 0.25);
    case 2:
      return 1e-160 * white;
    case 3:
      return std::pow(10.0, k % 100) * white;
    case 4:
      return white(0) * Eigen::Vector4d(1.0, 1.0 + 1e-15, -1.0, 1.0);
    case 5:
      return Eigen::Vector4d::Unit(k % 4) * std::pow(10.0, k % 37 - 18);
    default:
      return white;
  }
}

void survive(const RlsParams& params, int samples) {
  Rls<4> rls = Rls<4>::create(params).value();
  int judged = 0;
  for (int k = 0; k < samples; ++k) {
    const double size = k % 11 == 0 ? std::pow(10.0, k % 90) : 1.0;
    rls.update(nasty_regressor(k), size * Eigen::Vector3d(1.0, k % 3 - 1.0, -0.5));
    ASSERT_TRUE(rls.covariance_trace() > 0.0 && rls.covariance_trace() <= params.covariance_limit)
        << k << ": " << rls.covariance_trace() << ", " << to_string(rls.status());
    if (k % 97 == 0) {
      ++judged;
      const Eigen::Matrix4d p = rls.covariance();
      ASSERT_EQ(p, p.transpose()) << k;
      ASSERT_TRUE(p.allFinite() && rls.parameters().allFinite() && rls.residual_variance().allFinite()) << k;
      ASSERT_GT(p.diagonal().minCoeff(), 0.0) << k;
      ASSERT_GE(rls.residual_variance().minCoeff(), 0.0) << k;
    }
  }
  EXPECT_GT(judged, 10000);
  EXPECT_GT(rls.samples(), samples / 2);
}

TEST(Rls, KeepsASymmetricPositiveCovarianceThroughAMillionNastySamples) {
  survive({0.9, 1e3, 1e6, 0.0}, 1'000'000);
  survive({0.5, 1e3, 1e40, 0.0}, 1'000'000);
  survive({1.0, 1e-3, 1e2, 1e-9}, 1'000'000);
}

TEST(Rls, CovarianceIsPositiveDefiniteAfterNastySamples) {
  Rls<4> rls = Rls<4>::create({0.9, 1e3, 1e6, 0.0}).value();
  for (int k = 0; k < 100'000; ++k) {
    rls.update(nasty_regressor(k), Eigen::Vector3d(1.0, k % 3 - 1.0, -0.5));
  }
  // An entry of D climbs from its floor to 1 in ln(1 / (eps^2 1e6)) / ln(1 / 0.9) = 560 samples, errors of up to 1e43
  // fall to 1e-9 in 1140.
  constexpr int kEnough = 2000;
  for (const auto& [h, y] : excited<4>(truth(), 0.0, kEnough, 6)) {
    rls.update(h, y);
    const Eigen::LLT<Eigen::Matrix4d> factor(rls.covariance());
    EXPECT_EQ(factor.info(), Eigen::Success);
  }
  constexpr double kForgotten = 1e-9;
  EXPECT_LT((rls.parameters() - truth()).norm(), kForgotten) << "it recovers";
}

TEST(Rls, StartsAfreshAfterAReset) {
  Rls<4> rls = settled();
  rls.reset(truth());
  expect_same(rls, Rls<4>::create(kParams, truth()).value());
  EXPECT_EQ(rls.status(), RlsStatus::kNotYetSet);
  rls.reset(Eigen::Matrix<double, 3, 4>::Constant(kNaN));
  expect_same(rls, Rls<4>::create(kParams).value());
}

TEST(Rls, KeepsTheVariancesThatAResetGives) {
  Rls<4> rls = settled();
  const Eigen::Vector4d given(1.0, 1e-3, 2.0 * kParams.initial_covariance, -1.0);
  rls.reset(truth(), given);
  const Eigen::Matrix4d kept = rls.covariance();
  EXPECT_TRUE(kept.isDiagonal());
  EXPECT_EQ(kept(0, 0), 1.0);
  EXPECT_EQ(kept(1, 1), 1e-3);
  EXPECT_EQ(kept(2, 2), kParams.initial_covariance) << "none is more uncertain than at the start";
  EXPECT_GT(kept(3, 3), 0.0);
}

TEST(Rls, DoesNotAllocate) {
  Rls<4> rls = settled();
  double sum = 0.0;
  const test::AllocationGuard guard;
  for (int k = 0; k < 1000; ++k) {
    rls.update(Eigen::Vector4d(k % 3, 1.0, k % 7, 0.0), Eigen::Vector3d(1.0, k % 5, 0.0));
    sum += rls.parameters()(0, 0) + rls.covariance()(0, 0) + rls.residual_variance()(0) + rls.parameter_variance(1, 2);
  }
  rls.reset(Eigen::Matrix<double, 3, 4>::Zero());
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST(Rls, NamesEveryStatusAndKeepsTheNumbersOfTheThesis) {
  std::set<std::string> names;
  for (const RlsStatus status : {RlsStatus::kNotYetSet, RlsStatus::kOk, RlsStatus::kRegressorTooSmall,
                                 RlsStatus::kCovarianceNotPositiveDefinite, RlsStatus::kNotFinite}) {
    names.insert(to_string(status));
  }
  EXPECT_EQ(names.size(), 5u);
  EXPECT_EQ(names.count("unknown status"), 0u);
  EXPECT_EQ(static_cast<int>(RlsStatus::kCovarianceNotPositiveDefinite), 4);  // Table F.1
}

}  // namespace rls_safety_test
}  // namespace farrier::estimation
