#include "estimation/washout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "data.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace washout_test {

using testing::normal;

constexpr double kSmoothing = 1.0 / 8.0;  // 1 ms over 8 ms
constexpr double kRounding = 1e-12;       // of a few dozen sums of terms up to ten
// Ticks in which the slowest mode is gone: order 4, (1 - 1/8)^600 600^3 / 6 < 1e-27.
constexpr int kSettled = 600;

Eigen::Vector4d white(Tick k) { return normal<4>(1, "signal", k); }

TEST(Washout, RemovesAConstantExactly) {
  const Eigen::Vector4d constant(3.0, -0.2, 1e4, 0.7);
  for (int order = 1; order <= Washout::kMaxOrder; ++order) {
    Washout washout(kSmoothing, order);
    for (int k = 0; k < 100; ++k) {
      EXPECT_EQ(washout.pass(constant), Eigen::Vector4d::Zero()) << order << " at " << k;
    }
  }
}

TEST(Washout, RemovesAConstantFromWhatMovesOnTopOfIt) {
  const Eigen::Vector4d constant(3.0, -0.2, 4.0, 0.7);
  Washout without(kSmoothing, 3), with(kSmoothing, 3);
  for (Tick k = 0; k < 200; ++k) {
    EXPECT_LT((without.pass(white(k)) - with.pass(white(k) + constant)).norm(), kRounding) << k;
  }
}

// One stage turns a ramp of slope s into its lag, s (tau / T - 1); each further stage removes a constant.
TEST(Washout, LeavesAConstantOfARampWithOneStageAndNothingWithMore) {
  const Eigen::Vector4d slope(1e-3, -2e-3, 5e-3, 0.0);
  for (int order = 1; order <= Washout::kMaxOrder; ++order) {
    Washout washout(kSmoothing, order);
    Eigen::Vector4d out;
    for (int k = 0; k < kSettled; ++k) {
      out = washout.pass(k * slope);
    }
    const Eigen::Vector4d lag =
        order == 1 ? Eigen::Vector4d(slope * (1.0 / kSmoothing - 1.0)) : Eigen::Vector4d::Zero();
    EXPECT_LT((out - lag).norm(), kRounding) << order;
  }
}

TEST(Washout, LetsTheFastestSignalThroughAlmostWhole) {
  Washout washout(kSmoothing, 1);
  Eigen::Vector4d out;
  for (int k = 0; k < kSettled; ++k) {
    out = washout.pass(Eigen::Vector4d::Constant(k % 2 == 0 ? 1.0 : -1.0));
  }
  // |H(-1)| = 2 (1 - a) / (2 - a)
  EXPECT_NEAR(std::abs(out(0)), 2.0 * (1.0 - kSmoothing) / (2.0 - kSmoothing), kRounding);
}

TEST(Washout, OfOrderZeroLetsEverythingThrough) {
  Washout washout(kSmoothing, 0);
  for (Tick k = 0; k < 50; ++k) {
    EXPECT_EQ(washout.pass(white(k)), white(k));
  }
}

// Least squares relies on this: if signals obey x[k+1] = A x[k] + B u[k] + c, the washed-out signals obey
// x[k+1] = A x[k] + B u[k].
TEST(Washout, KeepsALinearModelOfTheSignals) {
  Eigen::Matrix3d a = normal<3, 3>(2, "a", 0);
  a *= 0.9 / test::eigenvalues(a).cwiseAbs().maxCoeff();
  const Eigen::Vector3d b = normal<3>(2, "b", 0), c(2.0, -3.0, 1.0);
  for (int order = 1; order <= Washout::kMaxOrder; ++order) {
    Washout washout(kSmoothing, order);
    Eigen::Vector3d x = normal<3>(2, "x", 0);
    Eigen::Vector4d last = Eigen::Vector4d::Zero();
    double largest_signal = 0.0;
    for (Tick k = 0; k < 2 * kSettled; ++k) {
      Eigen::Vector4d signal;
      signal << x, normal<1>(2, "u", k);
      const Eigen::Vector4d washed = washout.pass(signal);
      if (k > kSettled) {
        const Eigen::Vector3d residual = washed.head<3>() - a * last.head<3>() - b * last(3);
        ASSERT_LT(residual.norm(), kRounding) << order << " at " << k;
        largest_signal = std::max(largest_signal, washed.norm());
      }
      last = washed;
      x = a * x + b * signal(3) + c;
    }
    EXPECT_GT(largest_signal, 1.0) << "something was left to model";
  }
}

TEST(Washout, StartsAfreshAfterAReset) {
  Washout used(kSmoothing, 3), fresh(kSmoothing, 3);
  for (Tick k = 0; k < 100; ++k) {
    used.pass(white(k));
  }
  used.reset();
  for (Tick k = 100; k < 200; ++k) {
    EXPECT_EQ(used.pass(white(k)), fresh.pass(white(k)));
  }
}

}  // namespace washout_test
}  // namespace farrier::estimation
