// Errata of Hubacher (2014), Chapters 5, 7 and 8: the printed form is shown to be wrong and the corrected one right.
// docs/errata.md says which is which.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "control/design/lqr.hpp"
#include "control/numerics/riccati.hpp"
#include "control/numerics/spectrum.hpp"
#include "tests/unit/control/models.hpp"
#include "thesis_rig.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::thesis {
namespace thesis_errata_control_test {

using control::DiscreteModel;
using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

const Matrix4 kQ = Vector4(2.5, 1.0, 1.0, 5000.0).asDiagonal();  // (7.9)
constexpr double kR = 0.1;                                       // (7.10)

/// Integrator of the force before the normalised states, (7.7).
struct Augmented {
  Matrix4 a = Matrix4::Identity();
  Vector4 b = Vector4::Zero();
};

Augmented augmented(const control::testing::Rig& rig) {
  const DiscreteModel model = control::normalise(control::testing::sampled(rig), control::testing::kNormalisation);
  Augmented system;
  system.a(0, 3) = -1.0;
  system.a.bottomRightCorner<3, 3>() = model.a;
  system.b.tail<3>() = model.b;
  return system;
}

control::RiccatiSolution<4> solution_of(const Augmented& system) {
  return control::solve_dare<4>(system.a, system.b, kQ, kR, Vector4::Zero()).value();
}

/// Return difference's smallest size over the upper unit circle and the phase margin of u = -k x, degrees.
struct LoopMargins {
  double least_return_difference = 1e300;
  double phase_deg = 180.0;
};

LoopMargins margins(const Matrix4& a, const Vector4& b, const Eigen::RowVector4d& k) {
  LoopMargins result;
  const auto loop = [&](double angle) -> std::complex<double> {
    const std::complex<double> z = std::polar(1.0, angle);
    const Eigen::Matrix4cd pencil = z * Eigen::Matrix4cd::Identity() - a.cast<std::complex<double>>();
    return (k.cast<std::complex<double>>() * test::solve(pencil, b.cast<std::complex<double>>()))(0);
  };
  constexpr int kPoints = 20000;
  double before = std::abs(loop(1e-4));
  for (int i = 1; i <= kPoints; ++i) {
    const std::complex<double> value = loop(kPi * i / kPoints);
    result.least_return_difference = std::min(result.least_return_difference, std::abs(1.0 + value));
    if ((before - 1.0) * (std::abs(value) - 1.0) <= 0.0) {
      result.phase_deg = std::min(result.phase_deg, degrees(std::abs(std::arg(-value))));
    }
    before = std::abs(value);
  }
  return result;
}

TEST(ThesisErrata, LqrDiscreteTimeHasNoSixtyDegreeMargin) {  // 5.1, 10.1
  constexpr double kGridDeg = 0.2;  // what a step of the grid turns the loop's phase by near a crossing
  const std::pair<double, double> expected[] = {{0.5, 52.0}, {2.5, 28.1}, {50.0, 23.5}};  // kg, degrees
  for (const auto& [mass, phase_deg] : expected) {
    const Augmented system = augmented(control::testing::fc1d(mass));
    const auto solution = solution_of(system);
    const LoopMargins m = margins(system.a, system.b, solution.k);
    // Return difference equality: |1 + L|^2 >= R / (R + B'SB), which is less than one.
    const double guaranteed = std::sqrt(kR / (kR + (system.b.transpose() * solution.s * system.b)(0)));
    EXPECT_LT(guaranteed, 0.11) << mass;
    EXPECT_GE(m.least_return_difference, guaranteed) << mass;
    EXPECT_NEAR(m.phase_deg, phase_deg, kGridDeg) << mass;
  }
}

TEST(ThesisErrata, FullStateLqrWithoutSpringIsNotStabilisable) {  // 8.2.2: "always controllable"
  const Augmented free = augmented(control::testing::fc1d(2.5, 0.0));
  EXPECT_LT(control::stabilisability(free.a, free.b), 1e-13);
  EXPECT_GT(control::stabilisability(augmented(control::testing::fc1d(2.5)).a, free.b), 1e-4);
  const auto refused = control::solve_dare<4>(free.a, free.b, kQ, kR, Vector4::Zero());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), control::RiccatiStatus::kNotStabilisable);
}

TEST(ThesisErrata, RiccatiGainNeedsA) {  // (7.5)
  const Augmented system = augmented(control::testing::fc1d(50.0));
  const auto solution = solution_of(system);
  const double divisor = kR + (system.b.transpose() * solution.s * system.b)(0);
  const Eigen::RowVector4d right = system.b.transpose() * solution.s * system.a / divisor;
  const Eigen::RowVector4d printed = system.b.transpose() * solution.s / divisor;
  EXPECT_LT((right - solution.k).norm(), 1e-9 * right.norm());
  // The right gain lets the cost-to-go satisfy (7.4) as a Lyapunov equation of the closed loop; the printed one not.
  const auto cost_residual = [&](const Eigen::RowVector4d& k) -> double {
    const Matrix4 closed = system.a - system.b * k;
    const Matrix4 cost = closed.transpose() * solution.s * closed + kQ + k.transpose() * kR * k;
    return (cost - solution.s).norm() / solution.s.norm();
  };
  EXPECT_LT(cost_residual(right), 1e-9);
  EXPECT_GT(cost_residual(printed), 1e-3);
  EXPECT_NEAR(right(2), -4.47, 0.01);   // velocity: compensation
  EXPECT_NEAR(printed(2), 0.01, 0.01);  // lost
}

TEST(ThesisErrata, ErrorIsFedBackWithAPlus) {  // (7.6)
  const Augmented system = augmented(control::testing::fc1d(2.5));
  const Eigen::RowVector4d k = solution_of(system).k;
  // With r = 0 the error is -x: u = +K e is u = -K x, and u = -K e is u = +K x.
  EXPECT_LT(control::spectral_radius(Matrix4(system.a - system.b * k)), 1.0);
  EXPECT_GT(control::spectral_radius(Matrix4(system.a + system.b * k)), 1.0);
}

/// Steps of (8.1) from (8.2), N = 0.
std::vector<Matrix4> iterates(const Augmented& system, const Matrix4& q, double r, int count) {
  std::vector<Matrix4> s{q};
  for (int i = 0; i < count; ++i) {
    s.push_back(s.back() + control::riccati_residual<4>(system.a, system.b, q, r, Vector4::Zero(), s.back()));
  }
  return s;
}

TEST(ThesisErrata, RiccatiIterationConvergesLinearly) {  // 8.2.2, Fig. 8.9: "almost quadratically"
  const Augmented system = augmented(control::testing::fc1d(2.5));
  const auto solution = solution_of(system);
  const auto s = iterates(system, kQ, kR, 500);
  const double rate = std::pow(control::spectral_radius(Matrix4(system.a - system.b * solution.k)), 2);
  const auto error = [&](int k) { return (s[static_cast<std::size_t>(k)] - solution.s).norm(); };
  for (const int k : {100, 200, 400}) {
    EXPECT_NEAR(error(k + 1) / error(k), rate, 1e-3) << k;
    EXPECT_NEAR(std::log(error(k + 1) / error(k)) / std::log(error(k) / error(k - 1)), 1.0, 0.01) << k;
  }
  EXPECT_NEAR(error(100) / solution.s.norm(), 1.0e-3, 0.1e-3);
}

TEST(ThesisErrata, StopRuleIsNotRelative) {  // (8.3), RTOL = 0.4 on the square
  // The gain does not change when all weights are scaled. The step at which the rule stops does.
  const Augmented system = augmented(control::testing::fc1d(2.5));
  const Eigen::RowVector4d right = solution_of(system).k;
  for (const double scale : {1.0, 1e-2}) {
    const Matrix4 q = scale * kQ;
    const double r = scale * kR;
    const auto s = iterates(system, q, r, 500);
    std::size_t stop = 1;
    while (stop + 1 < s.size() && (s[stop] - s[stop - 1]).squaredNorm() >= 0.4) {
      ++stop;
    }
    const Eigen::RowVector4d k =
        system.b.transpose() * s[stop] * system.a / (r + (system.b.transpose() * s[stop] * system.b)(0));
    EXPECT_EQ(stop, scale == 1.0 ? 78u : 1u);
    EXPECT_NEAR(k(0) / right(0), scale == 1.0 ? 0.940 : 0.023, 0.002);  // integral gain
  }
}

TEST(ThesisErrata, ConditionsOfTheRiccatiEquationLackDetectability) {  // (8.5)
  // Controllable, R > 0, Q - N R^-1 N' = 0 >= 0: both conditions hold, and (8.1) rests at S_0 = 0 with gain zero.
  const Eigen::Matrix2d a{{1.2, 1.0}, {0.0, 0.5}};
  const Eigen::Vector2d b(0.0, 1.0);
  const Eigen::Matrix2d zero = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d n = Eigen::Vector2d::Zero();
  EXPECT_EQ(control::riccati_residual<2>(a, b, zero, 1.0, n, zero), zero);
  EXPECT_GT(control::spectral_radius(a), 1.0);
  const auto ours = control::solve_dare<2>(a, b, zero, 1.0, n);
  ASSERT_FALSE(ours.ok());
  EXPECT_EQ(ours.error(), control::RiccatiStatus::kClosedLoopUnstable);
}

TEST(ThesisErrata, PositionGainFallsWithMass) {  // caption of Fig. C.3; Fig. 7.4 has it right
  double before = 1e300;
  for (const double mass : {0.5, 1.0, 2.5, 10.0, 50.0, 127.0}) {
    const double gain = solution_of(augmented(control::testing::fc1d(mass))).k(1);
    EXPECT_GT(gain, 0.0) << mass;
    EXPECT_LT(gain, 0.8 * before) << mass;
    before = gain;
  }
}

TEST(ThesisErrata, GainsOfFigureSevenEightBelongToTheShortLine) {  // Table A.2
  control::testing::Rig rig = control::testing::fc1d(50.0);
  const Eigen::RowVector3d with_short = solution_of(augmented(rig)).k.tail<3>();
  rig.line_volume_m3 = 1.0207e-5;
  const Eigen::RowVector3d with_long = solution_of(augmented(rig)).k.tail<3>();
  const Eigen::RowVector3d figure(0.0, -4.0, 8.0);
  EXPECT_LT((with_short - figure).norm(), 0.8);
  EXPECT_GT((with_long - figure).norm(), 2.5);
}

TEST(ThesisErrata, PolesDoNotShowTheValve) {  // 5.3 (d), 8.2.1
  const control::testing::Rig rig = control::testing::fc1d(2.5);
  control::testing::Rig weak = rig;
  weak.valve_gain *= 0.5;
  const auto before = control::testing::sampled(rig);
  const auto after = control::testing::sampled(weak);
  EXPECT_EQ(before.a, after.a);
  EXPECT_LT((after.b - 0.5 * before.b).norm(), 1e-12 * before.b.norm());
}

}  // namespace thesis_errata_control_test
}  // namespace farrier::thesis
