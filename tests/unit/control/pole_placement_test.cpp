// Gains by placed poles: what is asked for is what the closed loop has.

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "control/design/closed_loop.hpp"
#include "control/design/design.hpp"
#include "control/numerics/spectrum.hpp"
#include "models.hpp"

namespace farrier::control {
namespace pole_placement_test {

using Complex = std::complex<double>;
using testing::kNormalisation;
using testing::kPeriodS;

/// Largest distance of a pole from the one of `wanted` it is paired with, nearest first.
template <class Found>
double misplacement(const Found& found, std::vector<Complex> wanted) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(wanted.size()); ++i) {
    const auto nearest = std::ranges::min_element(
        wanted, {}, [&](const Complex& p) { return std::abs(p - found[static_cast<std::size_t>(i)]); });
    worst = std::max(worst, std::abs(*nearest - found[static_cast<std::size_t>(i)]));
    *nearest = 1e9;
  }
  return worst;
}

template <int N>
void expect_placed_on_random_systems() {
  // Distinct poles at least 0.1 apart: eigenvalues of the closed loop answer for them to a few thousand roundings of
  // the size of b k. Far below the tolerance, and far below the distance.
  constexpr double kTolerance = 1e-6;
  for (int i = 0; i < 40; ++i) {
    const auto a = testing::random_matrix<Eigen::Matrix<double, N, N>>("pa", i);
    const auto b = testing::random_matrix<Eigen::Matrix<double, N, 1>>("pb", i);
    Eigen::Matrix<Complex, N, 1> poles;
    std::vector<Complex> wanted;
    for (int k = 0; k < N; ++k) {
      const bool pair = k < 2 * (N / 2);
      poles(k) = pair ? Complex(0.9 - 0.3 * (k / 2), k % 2 == 0 ? 0.2 : -0.2) : Complex(-0.3, 0.0);
      wanted.push_back(poles(k));
    }
    const auto k = place_poles<N>(a, b, poles);
    ASSERT_TRUE(k.ok()) << N << " states, system " << i << ": " << to_string(k.error());
    const SmallMatrix closed = a - b * k.value();
    const SmallSpectrum found = eigenvalues(closed);
    EXPECT_LT(misplacement(std::vector<Complex>(found.begin(), found.end()), wanted), kTolerance) << N << ", " << i;
  }
}

TEST(PolePlacement, PutsTheEigenvaluesOfRandomSystemsWhereTheyAreAskedFor) {
  expect_placed_on_random_systems<2>();
  expect_placed_on_random_systems<3>();
  expect_placed_on_random_systems<4>();
  expect_placed_on_random_systems<5>();
  expect_placed_on_random_systems<6>();
}

TEST(PolePlacement, AgreesWithAckermannsFormulaOnAWellConditionedSystem) {
  Eigen::Matrix3d a;
  a << 0.9, 0.3, 0.0, -0.2, 0.8, 0.4, 0.1, 0.0, 0.7;
  const Eigen::Vector3d b(0.1, 0.3, 1.0);
  const Eigen::Vector3cd poles(Complex(0.5, 0.3), Complex(0.5, -0.3), Complex(0.2, 0.0));
  Eigen::Matrix3d reach;
  reach << b, a * b, a * a * b;
  const Eigen::Matrix3d p =
      (a * a - a + 0.34 * Eigen::Matrix3d::Identity()) * (a - 0.2 * Eigen::Matrix3d::Identity());
  const Eigen::RowVector3d ackermann = Eigen::RowVector3d::UnitZ() * reach.inverse() * p;
  const auto k = place_poles<3>(a, b, poles);
  ASSERT_TRUE(k.ok());
  EXPECT_LT((k.value() - ackermann).norm(), 1e-12 * ackermann.norm() * 1e2);
}

TEST(PolePlacement, RefusesAPairWithAModeTheInputCannotMove) {
  const Eigen::Matrix3d a = Eigen::Vector3d(0.9, 0.5, 0.1).asDiagonal();
  const auto k = place_poles<3>(a, Eigen::Vector3d(1.0, 0.0, 1.0), Eigen::Vector3cd(0.1, 0.2, 0.3));
  ASSERT_FALSE(k.ok());
  EXPECT_EQ(k.error(), DesignStatus::kNotControllable);
}

DesignRule placing(double bandwidth_rad_s = 150.0, double damping = 0.9) {
  DesignRule rule;
  rule.method = DesignMethod::kPolePlacement;
  rule.poles = {bandwidth_rad_s, damping};
  return rule;
}

TEST(PolePlacement, ClosesTheForceLoopOfTheThesisWithThePolesItSays) {
  // Poles at the origin, one per tick of delay, are the least certain: n of them scatter by eps^(1/n).
  constexpr double kTolerance = 1e-4;
  for (const double mass_kg : {0.5, 2.5, 50.0}) {
    const DiscreteModel model = testing::sampled(testing::fc1d(mass_kg));
    for (int delay = 0; delay <= kMaxDelayTicks; ++delay) {
      const auto gains = design(model, placing(), kNormalisation, Form::kFullState, delay, kPeriodS);
      ASSERT_TRUE(gains.ok()) << mass_kg << " kg, " << delay << ": " << to_string(gains.error());
      const auto wanted = wanted_poles(model, placing().poles, Form::kFullState, kPeriodS);
      EXPECT_LT(misplacement(closed_loop_poles(model, gains.value(), delay), {wanted.begin(), wanted.end()}), kTolerance)
          << mass_kg << " kg, " << delay;
      EXPECT_LT(gains.value().spectral_radius, 1.0);
      EXPECT_EQ(gains.value().integral_factor, 1.0);
    }
  }
}

TEST(PolePlacement, ServesTheCompliantFormOfALegInSwingAndStance) {
  for (const double mass_kg : {2.5, 50.0}) {
    const DiscreteModel model = testing::sampled(testing::hyq(mass_kg));
    for (int delay = 0; delay <= kMaxDelayTicks; ++delay) {
      const auto gains = design(model, placing(), kNormalisation, Form::kCompliant, delay, kPeriodS);
      ASSERT_TRUE(gains.ok()) << mass_kg << " kg: " << to_string(gains.error());
      EXPECT_EQ(gains.value().position, 0.0);
      EXPECT_LT(closed_loop_spectral_radius(model, gains.value(), delay), 1.0);
    }
  }
}

TEST(PolePlacement, RefusesByName) {
  const DiscreteModel model = testing::sampled(testing::fc1d(2.5));
  const auto refusal = [&](const DesignRule& rule, const DiscreteModel& of, int delay, double period_s) {
    const auto gains = design(of, rule, kNormalisation, Form::kFullState, delay, period_s);
    return gains.ok() ? DesignStatus::kSuccessful : gains.error();
  };
  EXPECT_EQ(refusal(placing(0.0), model, 0, kPeriodS), DesignStatus::kPolesOutOfBounds);
  EXPECT_EQ(refusal(placing(4000.0), model, 0, kPeriodS), DesignStatus::kPolesOutOfBounds);
  EXPECT_EQ(refusal(placing(150.0, 0.0), model, 0, kPeriodS), DesignStatus::kPolesOutOfBounds);
  EXPECT_EQ(refusal(placing(std::nan("")), model, 0, kPeriodS), DesignStatus::kPolesOutOfBounds);
  EXPECT_EQ(refusal(placing(), model, 3, kPeriodS), DesignStatus::kDelayOutOfBounds);
  EXPECT_EQ(refusal(placing(), model, 0, 0.0), DesignStatus::kWrongSamplingTime);
  DiscreteModel broken = model;
  broken.a(1, 1) = std::nan("");
  EXPECT_EQ(refusal(placing(), broken, 0, kPeriodS), DesignStatus::kModelNotFinite);
  const DiscreteModel free = testing::sampled(testing::hyq(50.0));
  EXPECT_EQ(refusal(placing(), free, 0, kPeriodS), DesignStatus::kNotStabilisable) << "no spring, full state";
}

TEST(Design, ByWeightsIsTheLqr) {
  const DiscreteModel model = testing::sampled(testing::fc1d(2.5));
  const auto by_rule = design(model, {}, kNormalisation, Form::kFullState, 1, kPeriodS);
  const auto lqr = design_lqr(model, {}, kNormalisation, Form::kFullState, 1);
  ASSERT_TRUE(by_rule.ok() && lqr.ok());
  EXPECT_EQ(by_rule.value().force, lqr.value().force);
  EXPECT_EQ(by_rule.value().integral, lqr.value().integral);
  EXPECT_EQ(by_rule.value().delay, lqr.value().delay);
}

}  // namespace pole_placement_test
}  // namespace farrier::control
