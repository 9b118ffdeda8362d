#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models.hpp"

namespace farrier::control {
namespace discretise_test {

using testing::ContinuousModel;
using testing::kPeriodS;

/// Entry by entry in normalised units, where all are of like size.
double distance(const DiscreteModel& x, const DiscreteModel& y) {
  const DiscreteModel p = normalise(x, testing::kNormalisation);
  const DiscreteModel q = normalise(y, testing::kNormalisation);
  return std::max((p.a - q.a).cwiseAbs().maxCoeff() / q.a.cwiseAbs().maxCoeff(),
                  (p.b - q.b).cwiseAbs().maxCoeff() / q.b.cwiseAbs().maxCoeff());
}

/// Taylor series of the exponential over `pieces` equal parts of the period, in long double.
DiscreteModel by_taylor(const ContinuousModel& model, double period_s, int pieces) {
  using Matrix = Eigen::Matrix<long double, 4, 4>;
  Matrix m = Matrix::Zero();
  m.topLeftCorner<3, 3>() = model.a.cast<long double>() * (static_cast<long double>(period_s) / pieces);
  m.topRightCorner<3, 1>() = model.b.cast<long double>() * (static_cast<long double>(period_s) / pieces);
  Matrix term = Matrix::Identity();
  Matrix piece = Matrix::Identity();
  for (int i = 1; i <= 40; ++i) {
    term = (term * m / static_cast<long double>(i)).eval();
    piece += term;
  }
  Matrix whole = Matrix::Identity();
  for (int i = 0; i < pieces; ++i) {
    whole = (whole * piece).eval();
  }
  return {whole.topLeftCorner<3, 3>().cast<double>(), whole.topRightCorner<3, 1>().cast<double>()};
}

TEST(Discretise, AgreesWithTheTaylorSeriesOfFineSteps) {
  // Rounding of some ten products of normalised matrices of norm ~10.
  constexpr double kTolerance = 1e-13;
  for (const auto& rig : {testing::fc1d(0.5), testing::fc1d(50.0), testing::hyq(2.5), testing::hyq(50.0)}) {
    const ContinuousModel model = testing::force_model(rig);
    EXPECT_LT(distance(discretise(model.a, model.b, kPeriodS), by_taylor(model, kPeriodS, 256)), kTolerance);
  }
}

TEST(Discretise, OfTwoPeriodsIsTwiceThatOfOne) {
  constexpr double kTolerance = 1e-13;
  for (const double period_s : {1e-6, 1e-4, 1e-3, 1e-2}) {
    const ContinuousModel model = testing::force_model(testing::hyq(2.5));
    const DiscreteModel one = discretise(model.a, model.b, period_s);
    const DiscreteModel two = discretise(model.a, model.b, 2.0 * period_s);
    EXPECT_LT(distance(two, {one.a * one.a, one.a * one.b + one.b}), kTolerance) << period_s;
  }
}

TEST(Discretise, OfADoubleIntegratorIsExact) {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  a(0, 1) = 1.0;
  a(1, 2) = 1.0;
  const double t = 0.25;
  const DiscreteModel model = discretise(a, Eigen::Vector3d::Unit(2), t);
  Eigen::Matrix3d expected;
  expected << 1.0, t, t * t / 2.0, 0.0, 1.0, t, 0.0, 0.0, 1.0;
  constexpr double kTolerance = 4e-16;  // a few units in the last place of one
  EXPECT_LT((model.a - expected).cwiseAbs().maxCoeff(), kTolerance) << model.a;
  EXPECT_LT((model.b - Eigen::Vector3d(t * t * t / 6.0, t * t / 2.0, t)).cwiseAbs().maxCoeff(), kTolerance) << model.b;
}

TEST(Discretise, OfANonFiniteModelOrPeriodIsNotFinite) {
  const ContinuousModel model = testing::force_model(testing::hyq(2.5));
  EXPECT_FALSE(discretise(model.a * NAN, model.b, kPeriodS).a.allFinite());
  EXPECT_FALSE(discretise(model.a, model.b, 0.0).a.allFinite());
  EXPECT_FALSE(discretise(model.a, model.b, -kPeriodS).a.allFinite());
  EXPECT_FALSE(discretise(model.a, model.b, INFINITY).a.allFinite());
}

}  // namespace discretise_test
}  // namespace farrier::control
