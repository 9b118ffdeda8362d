#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimation/poles.hpp"
#include "data.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace poles_test {

using testing::normal;
using Complex = std::complex<double>;

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <int N>
Poles<N> by_qr(const Eigen::Matrix<double, N, N>& a) {
  const Eigen::VectorXcd values = test::eigenvalues(a);
  Poles<N> z;
  std::copy(values.begin(), values.end(), z.begin());
  return z;
}

/// Least product of a pole's distances to the others.
template <int N>
double separation(const Poles<N>& z) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < N; ++i) {
    double product = 1.0;
    for (int j = 0; j < N; ++j) {
      product *= j == i ? 1.0 : std::abs(z[i] - z[j]);
    }
    least = std::min(least, product);
  }
  return least;
}

template <int N>
void expect_equal_to_qr() {
  // Coefficients of the polynomial are off by a few eps |a|^N, which moves a root by that over its separation.
  constexpr double kFewEps = 20.0 * kEps;
  int complex_pairs = 0;
  for (int k = 0; k < 5000; ++k) {
    const Eigen::Matrix<double, N, N> a = normal<N, N>(1, "a", k);
    const Poles<N> z = poles(a);
    const double bound = kFewEps * std::pow(a.norm(), N) / separation<N>(z);
    EXPECT_LT(pole_distance<N>(z, by_qr<N>(a)), bound) << a;
    for (int i = 0; i + 1 < N; ++i) {
      EXPECT_GE(std::norm(z[i]), std::norm(z[i + 1])) << a;
    }
    for (int i = 0; i < N; ++i) {
      if (z[i].imag() > 0.0) {
        ++complex_pairs;
        ASSERT_LT(i + 1, N);
        EXPECT_EQ(z[i + 1], std::conj(z[i])) << a;
      }
    }
  }
  EXPECT_GT(complex_pairs, 500);
  EXPECT_LT(complex_pairs, 4500);
}

TEST(Poles, EqualThoseOfTheQrAlgorithm) {
  expect_equal_to_qr<2>();
  expect_equal_to_qr<3>();
}

TEST(Poles, AreExactWhereTheyAreWrittenDown) {
  const Poles<3> diagonal = poles<3>(Eigen::Vector3d(0.5, -0.9, 0.25).asDiagonal());
  EXPECT_LT(pole_distance<3>(diagonal, {-0.9, 0.5, 0.25}), 4.0 * kEps);
  EXPECT_NEAR(diagonal[0].real(), -0.9, 4.0 * kEps) << "largest modulus first";
  const Poles<3> zero = poles<3>(Eigen::Matrix3d::Zero());
  EXPECT_EQ(pole_distance<3>(zero, {0.0, 0.0, 0.0}), 0.0);
  const Poles<3> one = poles<3>(Eigen::Matrix3d::Identity());
  EXPECT_LT(pole_distance<3>(one, {1.0, 1.0, 1.0}), 4.0 * kEps);
  Eigen::Matrix2d turn;
  turn << std::cos(0.3), -std::sin(0.3), std::sin(0.3), std::cos(0.3);
  EXPECT_LT(pole_distance<2>(poles<2>(turn), {std::polar(1.0, 0.3), std::polar(1.0, -0.3)}), 4.0 * kEps);
}

TEST(Poles, OfAMatrixInMixedUnitsAreThoseOfTheBalancedOne) {
  for (int k = 0; k < 200; ++k) {
    const Eigen::Matrix3d a = normal<3, 3>(2, "a", k);
    const Eigen::Vector3d units(1.0, 1048576.0, 1.0 / 1024.0);
    const Eigen::Matrix3d scaled = units.asDiagonal() * a * units.cwiseInverse().asDiagonal();
    const double bound = 200.0 * kEps * std::pow(a.norm(), 3) / separation<3>(poles(a));
    EXPECT_LT(pole_distance<3>(poles(scaled), poles(a)), bound) << a;
  }
}

TEST(Poles, OfAnIntegratorChainAreFoundToTheRootOfThePrecision) {
  Eigen::Matrix3d chain;
  chain << 1.0, 1e-3, 5e-7, 0.0, 1.0, 1e-3, 0.0, 0.0, 1.0;
  EXPECT_LT(pole_distance<3>(poles(chain), {1.0, 1.0, 1.0}), std::cbrt(10.0 * kEps));
}

TEST(Poles, AreNotANumberForAMatrixThatIsNotFinite) {
  for (const double bad : {kNaN, HUGE_VAL, 1e200}) {
    for (int i = 0; i < 9; ++i) {
      Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
      a(i) = bad;
      const Poles<3> z = poles(a);
      EXPECT_TRUE(std::isnan(z[0].real()) && std::isnan(z[1].real()) && std::isnan(z[2].real()));
      EXPECT_EQ(pole_distance<3>(z, z), std::numeric_limits<double>::infinity());
      for (const double error : pole_standard_error<3>(a, z, Eigen::Vector3d::Ones(), Eigen::Matrix3d::Identity())) {
        EXPECT_EQ(error, 1.0);
      }
    }
  }
}

TEST(PoleDistance, IsTheLeastLargestDistanceOfAnyPairing) {
  const Poles<3> a{1.0, Complex(0.5, 0.1), Complex(0.5, -0.1)};
  EXPECT_EQ(pole_distance<3>(a, a), 0.0);
  const Poles<3> permuted{Complex(0.5, -0.1), 1.0, Complex(0.5, 0.1)};
  EXPECT_EQ(pole_distance<3>(a, permuted), 0.0);
  // Pairing each with its nearest would use 0 twice.
  EXPECT_DOUBLE_EQ(pole_distance<3>({0.0, 0.1, 5.0}, {0.0, 3.0, 5.0}), 2.9);
  EXPECT_DOUBLE_EQ(pole_distance<2>({0.9, 0.2}, {Complex(0.2, 0.3), 0.8}), 0.3);
}

TEST(PoleStandardError, IsTheSpreadOfThePolesUnderPerturbation) {
  constexpr int kRuns = 20000;
  constexpr double kScale = 1e-4;  // squared over a separation of 0.01: the second order is 1e-6
  for (int system = 0; system < 6; ++system) {
    Eigen::Matrix3d a = normal<3, 3>(3, "a", system);
    a *= 0.9 / a.norm();
    const Eigen::Matrix3d root = normal<3, 3>(4, "root", system);
    const Eigen::Matrix3d covariance = root * root.transpose();
    const Eigen::Vector3d sigma = kScale * Eigen::Vector3d(1.0, 0.3, 2.0);
    const Poles<3> z = poles(a);
    ASSERT_GT(separation<3>(z), 0.01) << "seed with poles too close for this test";
    const auto claimed = pole_standard_error<3>(a, z, sigma.cwiseAbs2(), covariance);
    std::array<double, 3> squares{};
    for (int run = 0; run < kRuns; ++run) {
      // Row r of the error: sigma_r root times white noise, of covariance sigma_r^2 P.
      const Eigen::Matrix3d white = normal<3, 3>(5 + system, "error", run);
      const Poles<3> moved = poles<3>(a + sigma.asDiagonal() * (root * white).transpose());
      for (int i = 0; i < 3; ++i) {
        squares[i] += std::norm(moved[i] - z[i]) / kRuns;
      }
    }
    // A variance of kRuns runs spreads by sqrt(2 / kRuns), its root by half of that: ten times that.
    const double tolerance = 5.0 * std::sqrt(2.0 / kRuns);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(std::sqrt(squares[i]) / claimed[i], 1.0, tolerance) << "system " << system << ", pole " << z[i];
    }
  }
}

TEST(PoleStandardError, OfTwoStatesIsTheSpreadUnderPerturbation) {
  constexpr int kRuns = 20000;
  Eigen::Matrix2d a;
  a << 0.9, 0.2, -0.4, 0.7;
  const Eigen::Vector2d sigma(1e-4, 3e-4);
  const auto claimed = pole_standard_error<2>(a, poles(a), sigma.cwiseAbs2(), Eigen::Matrix2d::Identity());
  double square = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    square += std::norm(poles<2>(a + sigma.asDiagonal() * normal<2, 2>(6, "error", run))[0] - poles(a)[0]) / kRuns;
  }
  EXPECT_NEAR(std::sqrt(square) / claimed[0], 1.0, 5.0 * std::sqrt(2.0 / kRuns));
  EXPECT_EQ(claimed[0], claimed[1]) << "a pair has one error";
}

TEST(PoleStandardError, SaturatesWherePolesMeet) {
  Eigen::Matrix3d defective;
  defective << 0.5, 1.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.2;
  const Eigen::Vector3d variance = Eigen::Vector3d::Constant(1e-6);
  const Poles<3> z = poles(defective);
  const auto error = pole_standard_error<3>(defective, z, variance, Eigen::Matrix3d::Identity());
  for (int i = 0; i < 3; ++i) {
    if (std::abs(z[i] - 0.5) < 0.1) {
      EXPECT_EQ(error[i], 1.0);
    } else {
      EXPECT_LT(error[i], 0.1);
    }
  }
  for (const double e : pole_standard_error<3>(Eigen::Matrix3d::Identity(), poles<3>(Eigen::Matrix3d::Identity()),
                                               variance, Eigen::Matrix3d::Identity())) {
    EXPECT_EQ(e, 1.0);
  }
}

TEST(Poles, AndTheirErrorsDoNotAllocate) {
  const Eigen::Matrix3d a = normal<3, 3>(7, "a", 0);
  const test::AllocationGuard guard;
  const Poles<3> z = poles(a);
  const double distance = pole_distance<3>(z, z);
  const auto error = pole_standard_error<3>(a, z, Eigen::Vector3d::Ones(), Eigen::Matrix3d::Identity());
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(distance + error[0]));
}

}  // namespace poles_test
}  // namespace farrier::estimation
