// Errata of Hubacher (2014), Chapters 5, 7 and 8: the printed form is shown to be wrong and the corrected one right.
// docs/errata.md says which is which.

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <vector>

#include "control/closed_loop.hpp"
#include "control/lqr.hpp"
#include "control/riccati.hpp"
#include "control/spectrum.hpp"
#include "control_models.hpp"
#include "thesis_rig.hpp"

namespace farrier::thesis {
namespace {

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
  const DiscreteModel model =
      control::normalise(control::testing::sampled(rig), control::testing::kNormalisation);
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
    return (k.cast<std::complex<double>>() * pencil.partialPivLu().solve(b.cast<std::complex<double>>()))(0);
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
  for (const double mass : {0.5, 2.5, 50.0}) {
    const Augmented system = augmented(control::testing::fc1d(mass));
    const auto solution = solution_of(system);
    const LoopMargins m = margins(system.a, system.b, solution.k);
    std::printf("mass %g pm %.2f rd %.4f bound %.4f\n", mass, m.phase_deg, m.least_return_difference,
                std::sqrt(kR / (kR + (system.b.transpose() * solution.s * system.b)(0))));
    // Return difference equality: |1 + L|^2 >= R / (R + B'SB), which is less than one.
    const double guaranteed = std::sqrt(kR / (kR + (system.b.transpose() * solution.s * system.b)(0)));
    EXPECT_GE(m.least_return_difference, guaranteed * (1.0 - 1e-9));
    EXPECT_LT(m.phase_deg, 60.0);
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
  std::printf("radius right %.5f printed %.5f\n", control::spectral_radius(Matrix4(system.a - system.b * right)),
              control::spectral_radius(Matrix4(system.a - system.b * printed)));
  std::cout << right << "\n" << printed << "\n";
}

TEST(ThesisErrata, ErrorIsFedBackWithAPlus) {  // (7.6)
  const Augmented system = augmented(control::testing::fc1d(2.5));
  const Eigen::RowVector4d k = solution_of(system).k;
  // With r = 0 the error is -x: u = +K e is u = -K x, and u = -K e is u = +K x.
  EXPECT_LT(control::spectral_radius(Matrix4(system.a - system.b * k)), 1.0);
  EXPECT_GT(control::spectral_radius(Matrix4(system.a + system.b * k)), 1.0);
}

TEST(ThesisErrata, IntegralFactorLeavesTheOptimum) {  // (7.11)
  for (const double mass : {0.5, 2.5, 50.0}) {
    const Augmented system = augmented(control::testing::fc1d(mass));
    Eigen::RowVector4d k = solution_of(system).k;
    const double before = margins(system.a, system.b, k).phase_deg;
    k(0) *= 6.0;
    const double after = margins(system.a, system.b, k).phase_deg;
    std::printf("mass %g pm xi1 %.2f xi6 %.2f rho %.5f\n", mass, before, after, control::spectral_radius(Matrix4(system.a - system.b * k)));
    EXPECT_LT(after, before);
  }
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
  const auto s = iterates(system, kQ, kR, 2000);
  const double rate = solution.spectral_radius * solution.spectral_radius;
  std::printf("rho^2 %.6f\n", rate);
  for (const int k : {100, 200, 400, 800}) {
    const double error = (s[k] - solution.s).norm();
    std::printf("%d rel %.3e ratio %.6f order %.3f\n", k, error / solution.s.norm(), (s[k + 1] - solution.s).norm() / error,
      std::log((s[k + 1] - solution.s).norm() / error) / std::log(error / (s[k - 1] - solution.s).norm()));
  }
}

TEST(ThesisErrata, StopRuleIsNotRelative) {  // (8.3), RTOL = 0.4 on the square
  const Augmented system = augmented(control::testing::fc1d(2.5));
  const auto solution = solution_of(system);
  for (const double scale : {1.0, 1e-2, 1e-4}) {
    const Matrix4 q = scale * kQ;
    const double r = scale * kR;
    const auto s = iterates(system, q, r, 3000);
    std::size_t stop = 1;
    while (stop + 1 < s.size() && (s[stop] - s[stop - 1]).squaredNorm() >= 0.4) {
      ++stop;
    }
    const Eigen::RowVector4d k =
        system.b.transpose() * s[stop] * system.a / (r + (system.b.transpose() * s[stop] * system.b)(0));
    std::printf("scale %g stop %zu gain error %.4f radius %.5f\n", scale, stop, (k - solution.k).norm() / solution.k.norm(),
      control::spectral_radius(Matrix4(system.a - system.b * k)));
    std::cout << k << " vs " << solution.k << "\n";
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
  std::printf("ours: %s\n", ours.ok() ? "ok" : control::to_string(ours.error()));
}

TEST(ThesisErrata, PositionGainAndMass) {  // Figs 7.4 and C.3
  for (const double mass : {0.5, 1.0, 2.5, 10.0, 50.0, 127.0}) {
    const auto k = solution_of(augmented(control::testing::fc1d(mass))).k;
    std::cout << mass << " : " << k << "\n";
  }
  control::testing::Rig rig = control::testing::fc1d(50.0);
  rig.line_volume_m3 = 1.0207e-5;
  std::cout << "long " << solution_of(augmented(rig)).k << "\n";
  for (const double d : {0.0, 100.0, 500.0, 2000.0}) for (double m : {2.5, 50.0}) {
    auto r = control::testing::fc1d(m); r.load_damping = d;
    std::cout << m << " d " << d << " : " << solution_of(augmented(r)).k << "\n";
  }
  for (const double c : {10.0, 2000.0, 21480.0, 35000.0}) std::cout << "C " << c << ": " << solution_of(augmented(control::testing::fc1d(2.5, c))).k << "\n";
}

}  // namespace
}  // namespace farrier::thesis
