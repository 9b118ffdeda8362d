#include <gtest/gtest.h>


#include <algorithm>
#include <limits>

#include "control/design/closed_loop.hpp"
#include "control/numerics/francis.hpp"
#include "control/numerics/spectrum.hpp"
#include "tests/unit/control/models.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::control {
namespace spectrum_test {

using testing::kNormalisation;
using testing::random_matrix;

constexpr int kCases = 400;
// A backward stable method finds eigenvalues of a matrix a few N rounding errors of its norm away.
constexpr double kBackwardErrorPerRow = 16.0 * std::numeric_limits<double>::epsilon();
// Tolerance that closed_loop_spectral_radius promises.
constexpr double kRadiusTolerance = 1e-6;

/// Dense, with zeros, badly scaled, or with a last row of zeros, by number.
template <int N>
Eigen::Matrix<double, N, N> some_matrix(int number) {
  using Matrix = Eigen::Matrix<double, N, N>;
  Matrix m = random_matrix<Matrix>("m", number);
  const Matrix pattern = random_matrix<Matrix>("pattern", number);
  switch (number % 4) {
    case 1: m = (pattern.array() > 0.3).select(0.0, m); break;
    case 2: m.array() *= (4.0 * pattern.array()).exp(); break;
    case 3: m.row(N - 1).setZero(); break;
    default: break;
  }
  return m;
}

template <int N>
void expect_backward_stable() {
  for (int number = 0; number < kCases; ++number) {
    const Eigen::Matrix<double, N, N> m = some_matrix<N>(number);
    Eigen::Matrix<std::complex<double>, N, 1> z;
    ASSERT_TRUE(francis_eigenvalues<N>(m, z)) << m;
    const double tolerance = N * kBackwardErrorPerRow * m.norm();
    EXPECT_NEAR(z.sum().real(), m.trace(), tolerance) << m;
    EXPECT_NEAR(z.sum().imag(), 0.0, tolerance) << "pairs cancel";
    for (int i = 0; i < N; ++i) {
      Eigen::Matrix<std::complex<double>, N, N> shifted = m.template cast<std::complex<double>>();
      shifted.diagonal().array() -= z(i);
      EXPECT_LE(test::singular_values(shifted)(N - 1), tolerance) << z(i) << " of\n" << m;
    }
  }
}

TEST(FrancisEigenvalues, BelongToAMatrixARoundingErrorAway) {
  expect_backward_stable<2>();
  expect_backward_stable<3>();
  expect_backward_stable<4>();
  expect_backward_stable<5>();
  expect_backward_stable<6>();
}

TEST(FrancisEigenvalues, AreExactForTriangularMatricesAndCyclesTakeExceptionalShifts) {
  Eigen::Matrix<std::complex<double>, 4, 1> z;
  Eigen::Matrix4d triangle = random_matrix<Eigen::Matrix4d>("triangle", 0).triangularView<Eigen::Upper>();
  ASSERT_TRUE(francis_eigenvalues<4>(triangle, z));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(z(i), triangle(i, i));
  }
  ASSERT_TRUE(francis_eigenvalues<4>(Eigen::Matrix4d::Zero(), z));
  EXPECT_TRUE(z.isZero(0.0));
  // Without exceptional shifts the iteration leaves a permutation as it is. Its eigenvalues are the fourth roots of
  // one.
  Eigen::Matrix4d cycle = Eigen::Matrix4d::Zero();
  cycle(0, 3) = cycle(1, 0) = cycle(2, 1) = cycle(3, 2) = 1.0;
  ASSERT_TRUE(francis_eigenvalues<4>(cycle, z));
  for (int i = 0; i < 4; ++i) {
    EXPECT_LE(std::abs(z(i) * z(i) * z(i) * z(i) - 1.0), 16 * kBackwardErrorPerRow) << z(i);
  }
}

TEST(FrancisEigenvalues, RefuseWhatIsNotFinite) {
  Eigen::Matrix<std::complex<double>, 3, 1> z;
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Identity();
    m(1, 2) = bad;
    EXPECT_FALSE(francis_eigenvalues<3>(m, z)) << bad;
  }
}

// Products of such entries would overflow or vanish.
TEST(FrancisEigenvalues, ScaleWithMatricesOfAnySize) {
  const Eigen::Matrix3d m = some_matrix<3>(1);
  Eigen::Matrix<std::complex<double>, 3, 1> z, scaled;
  ASSERT_TRUE(francis_eigenvalues<3>(m, z));
  for (const int exponent : {-900, -300, 300, 900}) {
    const double factor = std::ldexp(1.0, exponent);
    ASSERT_TRUE(francis_eigenvalues<3>(factor * m, scaled)) << exponent;
    EXPECT_LE((scaled / factor - z).norm(), 3 * kBackwardErrorPerRow * m.norm()) << exponent;
  }
  EXPECT_EQ(spectral_radius(1e80 * Eigen::Matrix3d::Identity()), 1e80);
}

template <int N>
void expect_same_verdict() {
  using Square = Eigen::Matrix<double, N, N>;
  using Column = Eigen::Matrix<double, N, 1>;
  for (int number = 0; number < kCases; ++number) {
    Square a = random_matrix<Square>("a", number);
    a *= (0.5 + 0.001 * number) / spectral_radius(a);
    Column b = random_matrix<Column>("b", number);
    // An integrator that the input reaches through a coupling of 10^-2 to 10^-13, or not at all.
    a.row(0).setZero();
    a(0, 0) = 1.0;
    a(0, N - 1) = number % 13 == 12 ? 0.0 : std::pow(10.0, -2 - number % 12);
    b(0) = 0.0;
    EXPECT_EQ(is_stabilisable<N>(a, b), stabilisability(a, b) >= kStabilisabilityThreshold) << a << "\n" << b;
  }
}

TEST(Stabilisability, IsToldFromALowerBoundAsFromTheSingularValues) {
  expect_same_verdict<3>();
  expect_same_verdict<4>();
  expect_same_verdict<5>();
  expect_same_verdict<6>();
}

TEST(Stabilisability, OfWhatIsNotFiniteIsNotThere) {
  Eigen::Matrix3d a = 0.5 * Eigen::Matrix3d::Identity();
  EXPECT_TRUE(is_stabilisable<3>(a, Eigen::Vector3d::Zero()));
  EXPECT_FALSE(is_stabilisable<3>(a, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())));
  a(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_stabilisable<3>(a, Eigen::Vector3d::Ones()));
}

/// Sum of force errors, x, v, F and both past inputs, always all of them, by a general eigenvalue solver; without the
/// position for the compliant form.
double radius_of_all_states(const DiscreteModel& model, const Gains& gains, int delay_ticks) {
  const DiscreteModel plant = normalise(model, gains.normalisation);
  Eigen::Matrix<double, 1, 6> command;
  command << gains.integral_factor * gains.integral, -gains.position, -gains.velocity, -gains.force, -gains.delay[0],
      -gains.delay[1];
  Eigen::Matrix<double, 6, 6> loop = Eigen::Matrix<double, 6, 6>::Zero();
  loop(0, 0) = 1.0;
  loop(0, 3) = -1.0;
  loop.block<3, 3>(1, 1) = plant.a;
  const Eigen::Matrix<double, 1, 6> acting =
      delay_ticks == 0 ? command : Eigen::Matrix<double, 1, 6>::Unit(3 + delay_ticks).eval();
  loop.middleRows<3>(1) += plant.b * acting;
  loop.row(4) = command;
  loop(5, 4) = 1.0;
  if (gains.form == Form::kCompliant) {
    loop.row(1).setZero();
    loop.col(1).setZero();
  }
  return test::eigenvalues(loop).cwiseAbs().maxCoeff();
}

TEST(ClosedLoopRadius, LeavesOutOnlyStatesThatNobodyReads) {
  for (int number = 0; number < kCases; ++number) {
    const Eigen::Vector4d draw = random_matrix<Eigen::Vector4d>("load", number);
    const testing::Rig rig{1.8181e9, 8.17e-6, 6.12e-6, 160e5, 10.0 * std::exp(draw(0)), 500.0 * std::exp(draw(1)), 2e4};
    const Form form = number % 2 == 0 ? Form::kCompliant : Form::kFullState;
    const DiscreteModel model = testing::sampled(rig);
    for (int designed = 0; designed <= kMaxDelayTicks; ++designed) {
      const auto gains = design_lqr(model, {}, kNormalisation, form, designed);
      if (!gains) {
        continue;
      }
      DiscreteModel unlike = model;
      unlike.b *= std::exp(0.3 * draw(2));
      for (int delay_ticks = 0; delay_ticks <= kMaxDelayTicks; ++delay_ticks) {
        const double all = radius_of_all_states(unlike, gains.value(), delay_ticks);
        EXPECT_NEAR(closed_loop_spectral_radius(unlike, gains.value(), delay_ticks), all, kRadiusTolerance)
            << "designed for " << designed << ", acts " << delay_ticks << " late, case " << number;
      }
    }
  }
}

TEST(ClosedLoopRadius, IsNotANumberForGainsThatAreNot) {
  const DiscreteModel model = testing::sampled(testing::hyq(10.0));
  for (const std::size_t place : {0, 1}) {
    Gains gains = design_lqr(model, {}, kNormalisation, Form::kCompliant, 0).value();
    gains.delay[place] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(closed_loop_spectral_radius(model, gains, 0))) << place;
  }
}

}  // namespace spectrum_test
}  // namespace farrier::control
