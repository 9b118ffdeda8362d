// Errata of Hubacher (2014), Chapters 6 and 9 and Appendix B: the printed form is shown to be wrong and the corrected
// one right. docs/errata.md says which is which.

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

#include "control/model/discretise.hpp"
#include "control/design/lqr.hpp"
#include "tests/unit/control/models.hpp"
#include "estimation/rls.hpp"
#include "thesis_rig.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::thesis {
namespace thesis_errata_estimation_test {

using control::testing::random_matrix;

TEST(ThesisErrata, InverseLemmaAsPrintedIsWrong) {  // (B.15)
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3d a = 5.0 * Eigen::Matrix3d::Identity() + random_matrix<Eigen::Matrix3d>("a", i);
    const Eigen::Matrix3d b = random_matrix<Eigen::Matrix3d>("b", i);
    const Eigen::Matrix3d c = 5.0 * Eigen::Matrix3d::Identity() + random_matrix<Eigen::Matrix3d>("c", i);
    const Eigen::Matrix3d d = random_matrix<Eigen::Matrix3d>("d", i);
    const Eigen::Matrix3d sum = a + b * c * d;
    const Eigen::Matrix3d ai = a.inverse();
    const Eigen::Matrix3d right = ai - ai * b * (c.inverse() + d * ai * b).inverse() * d * ai;
    const Eigen::Matrix3d printed = ai - ai * b * (d.inverse() * a + c.inverse()).inverse() * d * ai;
    const double condition = sum.norm() * sum.inverse().norm() * ai.norm() * a.norm();
    EXPECT_LT((right * sum - Eigen::Matrix3d::Identity()).norm(), condition * condition * kRounding) << i;
    EXPECT_GT((printed * sum - Eigen::Matrix3d::Identity()).norm(), 0.1) << i;
  }
}

TEST(ThesisErrata, HeldInputIsIntegratedOverTau) {  // (B.5)
  // The rig's model; the printed integrand does not depend on tau, so its integral is T exp(A T) B.
  const auto model = control::testing::force_model(control::testing::fc1d(2.5));
  const double period = control::testing::kPeriodS;
  const auto exact = control::discretise(model.a, model.b, period);
  const Eigen::Vector3d printed = period * exact.a * model.b;
  // Simpson's rule over tau with n = 1000 parts of the period: error (||A|| T)^4 / (180 n^4).
  constexpr int kParts = 1000;
  Eigen::Vector3d sum = model.b + exact.a * model.b;
  for (int i = 1; i < kParts; ++i) {
    sum += (i % 2 == 1 ? 4.0 : 2.0) * control::discretise(model.a, model.b, period * i / kParts).a * model.b;
  }
  const Eigen::Vector3d integral = sum * period / (3.0 * kParts);
  EXPECT_LT((integral - exact.b).norm(), 1e-9 * exact.b.norm());
  EXPECT_NEAR(printed(2) / exact.b(2), 0.60, 0.01);
}

/// H of (6.29)-(6.31) for the joint: three states, one input.
Eigen::Matrix<double, 3, 12> regression_matrix(const Eigen::Vector3d& x, double u) {
  Eigen::Matrix<double, 3, 12> h = Eigen::Matrix<double, 3, 12>::Zero();
  for (int row = 0; row < 3; ++row) {
    h.block<1, 3>(row, 3 * row) = x.transpose();
    h(row, 9 + row) = u;
  }
  return h;
}

TEST(ThesisErrata, ExcitationNeedsTheGramMatrix) {  // (9.4)
  // One direction only: three of the four parameters of a row cannot be told.
  const Eigen::Vector3d x(0.3, -0.5, 0.2);
  Eigen::Matrix3d printed = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 12, 12> gram = Eigen::Matrix<double, 12, 12>::Zero();
  double energy = 0.0;
  for (int i = 0; i < 50; ++i) {
    const double size = 1.0 + 0.5 * std::sin(i);
    const auto h = regression_matrix(size * x, size * 0.4);
    printed += h * h.transpose();
    gram += h.transpose() * h;
    energy += size * size * (x.squaredNorm() + 0.16);
  }
  EXPECT_LT((printed - energy * Eigen::Matrix3d::Identity()).norm(), 1e3 * kRounding * energy);
  const Eigen::VectorXd spectrum = test::symmetric_eigenvalues(gram);
  EXPECT_LT(std::abs(spectrum(8)), 1e3 * kRounding * energy);  // rank 3 of 12
  EXPECT_GT(spectrum(9), 0.5 * energy);
}

TEST(ThesisErrata, OneTimeConstantLeavesAThirdOfTheOldSystem) {  // (6.22) as used in 6.3.3
  const double samples = 0.25 * 0.125 / 1e-3;  // a quarter of the stance phase at 4 Hz
  const double forgetting = 1.0 - 1.0 / samples;
  EXPECT_NEAR(forgetting, 0.968, 1e-9);
  EXPECT_NEAR(std::pow(forgetting, samples), 0.362, 0.001);
  // To leave 1 % of the old samples' weight at that time:
  EXPECT_NEAR(std::pow(0.01, 1.0 / samples), 0.863, 0.001);
}

TEST(ThesisErrata, GainGrowsUnderWeakExcitationInsteadOfVanishing) {  // (6.23)
  const double forgetting = 0.9;
  const double h = 1e-3;  // noise on a resting joint
  double p = 1.0;
  const auto gain = [&] { return p * h / (h * p * h + forgetting); };  // (6.20)
  const double first = gain();
  for (int i = 0; i < 400; ++i) {
    p = p / (h * p * h + forgetting);  // (6.19)
  }
  EXPECT_NEAR(first, 1.11e-3, 0.01e-3);
  // At rest h^2 p + lambda = 1, so p = (1 - lambda) / h^2 and the gain is (1 - lambda) / h.
  EXPECT_NEAR(gain(), (1.0 - forgetting) / h, 1e-6 * (1.0 - forgetting) / h);
}

TEST(ThesisErrata, SamplingAHeldInputDoesNotAlias) {  // 6.3.1
  // The light load of Fig. 6.2, column three: its response has not decayed at half the sampling rate. Least squares
  // still finds the sampled model to rounding, since the input is held and the whole state is measured.
  const auto model = control::normalise(control::testing::sampled(control::testing::fc1d(0.5)),
                                        control::testing::kNormalisation);
  const Eigen::Matrix3d nyquist = -Eigen::Matrix3d::Identity() - model.a;
  const double response = std::abs(nyquist.inverse().row(2).dot(model.b));
  auto rls = estimation::Rls<4>::create({0.85, 1e3, 1e12, 0.0}).value();
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (int tick = 0; tick < 200; ++tick) {
    const double u = 0.05 * random_matrix<Eigen::Matrix<double, 1, 1>>("valve", tick)(0);
    Eigen::Vector4d h;
    h << x, u;
    x = model.a * x + model.b * u;
    rls.update(h, x);
  }
  Eigen::Matrix<double, 3, 4> truth;
  truth << model.a, model.b;
  EXPECT_GT(response, 0.05);
  // 0.85^200 is 1e-14 of the start's weight; the rest is rounding times the condition of the regressors.
  EXPECT_LT((rls.parameters() - truth).norm(), 1e-9 * truth.norm());
}

TEST(ThesisErrata, KalmanFormNeedsItsNoisesTheOtherWayRound) {  // (B.17)
  // One constant parameter seen through noise of variance one: the drift's variance is zero.
  constexpr int kSamples = 1000;
  double right = 0.0, printed = 0.0, p_right = 1e6, p_printed = 1e6, last = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double y = 2.0 + random_matrix<Eigen::Matrix<double, 1, 1>>("measurement", i)(0);
    const auto update = [y](double& theta, double& p, double in_innovation, double added) {
      const double k = p / (p + in_innovation);
      theta += k * (y - theta);
      p = p - k * p + added;
    };
    update(right, p_right, 1.0, 0.0);
    update(printed, p_printed, 0.0, 1.0);
    last = y;
  }
  EXPECT_DOUBLE_EQ(printed, last);                                 // follows the noise
  EXPECT_LT(std::abs(right - 2.0), 4.0 / std::sqrt(kSamples));     // four standard deviations of the mean
}

TEST(ThesisErrata, AdaptiveForgettingNeverReachesItsLowerLimit) {  // (9.3): "limited to [0.8, 1]"
  const auto forgetting = [](double error_squared, int unknowns) {
    return 1.0 - 2.0 * error_squared / (unknowns * (error_squared + 1.0));
  };
  EXPECT_NEAR(forgetting(1e12, 12), 5.0 / 6.0, 1e-9);  // all unknowns of (6.35)
  EXPECT_NEAR(forgetting(1e12, 4), 0.5, 1e-9);         // those of one measurement row
}

TEST(ThesisErrata, ForceOverVelocityIsNotViscousFriction) {  // (9.6)
  const double coulomb = 40.0, viscous = 500.0;  // N, Ns/m
  const auto force = [&](double v) { return coulomb + viscous * v; };
  EXPECT_NEAR(force(0.05) / 0.05, 1300.0, 1e-9);
  EXPECT_NEAR(force(0.4) / 0.4, 600.0, 1e-9);
  EXPECT_NEAR((force(0.4) - force(0.05)) / 0.35, viscous, 1e-9);
}

}  // namespace thesis_errata_estimation_test
}  // namespace farrier::thesis
