#include <gtest/gtest.h>

#include <cmath>

#include "control/numerics/riccati.hpp"
#include "control/numerics/spectrum.hpp"
#include "models.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::control {
namespace riccati_test {

constexpr int kCases = 200;
constexpr double kResidualTolerance = 1e-12;

template <int N>
struct Problem {
  Eigen::Matrix<double, N, N> a;
  Eigen::Matrix<double, N, 1> b;
  Eigen::Matrix<double, N, N> q;
  double r;
  Eigen::Matrix<double, N, 1> n;
};

/// Spectral radius 0.3..1.2, semi-definite Q of rank N - 1 plus a trace of identity, cross weight small enough for
/// (8.5): Q - N R^-1 N' = G G' + 0.01 I.
template <int N>
Problem<N> random_problem(int number) {
  Problem<N> p;
  p.a = testing::random_matrix<Eigen::Matrix<double, N, N>>("a", number);
  p.a *= (0.3 + 0.9 * number / kCases) / spectral_radius(p.a);
  p.b = testing::random_matrix<Eigen::Matrix<double, N, 1>>("b", number);
  p.r = std::pow(10.0, -2.0 + 4.0 * (number % 10) / 9.0);
  p.n = 0.3 * testing::random_matrix<Eigen::Matrix<double, N, 1>>("n", number);
  const auto g = testing::random_matrix<Eigen::Matrix<double, N, N - 1>>("g", number);
  p.q = g * g.transpose() + 0.01 * Eigen::Matrix<double, N, N>::Identity() + p.n * p.n.transpose() / p.r;
  return p;
}

template <class Size>
class Riccati : public ::testing::Test {};
template <int N>
struct States {
  static constexpr int kN = N;
};
using Sizes = ::testing::Types<States<2>, States<3>, States<4>, States<5>, States<6>>;
TYPED_TEST_SUITE(Riccati, Sizes);

TYPED_TEST(Riccati, SolutionSatisfiesTheEquationAndIsTheStabilisingOne) {
  constexpr int N = TypeParam::kN;
  for (int i = 0; i < kCases; ++i) {
    const auto p = random_problem<N>(i);
    const auto solution = solve_dare<N>(p.a, p.b, p.q, p.r, p.n);
    ASSERT_TRUE(solution.ok()) << to_string(solution.error()) << " case " << i;
    const auto& s = solution.value().s;
    const double residual = riccati_residual<N>(p.a, p.b, p.q, p.r, p.n, s).norm() / s.norm();
    EXPECT_LE(residual, kResidualTolerance) << "case " << i;
    EXPECT_DOUBLE_EQ(residual, solution.value().relative_residual);
    EXPECT_EQ(s, s.transpose());
    const Eigen::VectorXd spectrum = test::symmetric_eigenvalues(s);
    EXPECT_GE(spectrum(0), -1e-13 * spectrum(N - 1));
    EXPECT_LT(spectral_radius(p.a - p.b * solution.value().k), 1.0);
    EXPECT_LE(solution.value().iterations, 40);
  }
}

TYPED_TEST(Riccati, DoublingAgreesWithTheIterationOfTheThesis) {
  constexpr int N = TypeParam::kN;
  for (int i = 0; i < kCases; i += 10) {
    const auto p = random_problem<N>(i);
    const auto fast = solve_dare<N>(p.a, p.b, p.q, p.r, p.n);
    const auto slow = solve_dare_by_iteration<N>(p.a, p.b, p.q, p.r, p.n, 100000, kResidualTolerance);
    ASSERT_TRUE(fast.ok() && slow.ok());
    // An error of S decays with the square of the spectral radius: the last step is (1 - rho^2) of what is left.
    const double rho = spectral_radius(p.a - p.b * fast.value().k);
    const double tolerance = 100.0 * kResidualTolerance / (1.0 - rho * rho);
    EXPECT_LT((fast.value().s - slow.value().s).norm(), tolerance * fast.value().s.norm())
        << fast.value().s << "\n\n"
        << slow.value().s << "\ncase " << i;
    EXPECT_LT(fast.value().iterations, slow.value().iterations + 2);
  }
}

Problem<3> small_problem() { return random_problem<3>(7); }

RiccatiStatus refusal(const Problem<3>& p) {
  const auto solution = solve_dare<3>(p.a, p.b, p.q, p.r, p.n);
  return solution.ok() ? RiccatiStatus::kSolved : solution.error();
}

TEST(RiccatiRefusal, NamesAnUnreachableUnstableMode) {
  Problem<3> p = small_problem();
  p.a = Eigen::Vector3d(0.5, 1.1, 0.3).asDiagonal();
  p.b = {1.0, 0.0, 1.0};
  EXPECT_EQ(refusal(p), RiccatiStatus::kNotStabilisable);
}

TEST(RiccatiRefusal, NamesAnUnreachableIntegrator) {
  Problem<3> p = small_problem();
  p.a = Eigen::Vector3d(0.5, 1.0, 0.3).asDiagonal();
  p.b = {1.0, 0.0, 1.0};
  EXPECT_EQ(refusal(p), RiccatiStatus::kNotStabilisable);
  const auto slow = solve_dare_by_iteration<3>(p.a, p.b, p.q, p.r, p.n, 1000, kResidualTolerance);
  ASSERT_FALSE(slow.ok());
  EXPECT_EQ(slow.error(), RiccatiStatus::kNotStabilisable);
}

TEST(RiccatiRefusal, SolvesAnUnreachableModeThatDecays) {
  Problem<3> p = small_problem();
  p.a = Eigen::Vector3d(1.5, 0.9, 0.3).asDiagonal();
  p.b = {1.0, 0.0, 1.0};
  EXPECT_EQ(refusal(p), RiccatiStatus::kSolved);
}

TEST(RiccatiRefusal, NamesWeightsThatAreNotDefinite) {
  Problem<3> p = small_problem();
  p.r = 0.0;
  EXPECT_EQ(refusal(p), RiccatiStatus::kWeightsNotDefinite);
  p = small_problem();
  p.q(1, 1) = -1.0;
  EXPECT_EQ(refusal(p), RiccatiStatus::kWeightsNotDefinite);
  p = small_problem();
  p.n *= 1e3;
  EXPECT_EQ(refusal(p), RiccatiStatus::kWeightsNotDefinite);
  p = small_problem();
  p.q(0, 1) += 1.0;
  EXPECT_EQ(refusal(p), RiccatiStatus::kWeightsNotDefinite);
}

TEST(RiccatiRefusal, NamesWhatIsNotFinite) {
  Problem<3> p = small_problem();
  p.a(0, 0) = NAN;
  EXPECT_EQ(refusal(p), RiccatiStatus::kNotFinite);
  p = small_problem();
  p.r = INFINITY;
  EXPECT_EQ(refusal(p), RiccatiStatus::kNotFinite);
}

TEST(RiccatiRefusal, NamesAnUnstableModeWithoutWeight) {
  Problem<3> p = small_problem();
  p.a = Eigen::Vector3d(0.5, 1.1, 0.3).asDiagonal();
  p.b = {1.0, 1.0, 1.0};
  p.q = Eigen::Vector3d(1.0, 0.0, 1.0).asDiagonal();
  p.n.setZero();
  EXPECT_EQ(refusal(p), RiccatiStatus::kClosedLoopUnstable);
}

TEST(RiccatiRefusal, SaysWhenTheIterationHitItsBound) {
  const Problem<3> p = small_problem();
  const auto slow = solve_dare_by_iteration<3>(p.a, p.b, p.q, p.r, p.n, 2, kResidualTolerance);
  ASSERT_FALSE(slow.ok());
  EXPECT_EQ(slow.error(), RiccatiStatus::kNotConverged);
}

}  // namespace riccati_test
}  // namespace farrier::control
