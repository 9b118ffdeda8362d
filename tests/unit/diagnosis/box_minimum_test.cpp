// The quadratic minimum within a box, against its conditions of optimality.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/noise.hpp"
#include "diagnosis/judge/box_minimum.hpp"

namespace farrier::diagnosis {
namespace box_minimum_test {

struct Problem {
  Eigen::MatrixXd normal;
  Eigen::VectorXd descent, low, high;
};

/// Random problems whose normal matrix has eigenvalues down to 1e-6 of the largest.
Problem drawn(int number, Eigen::Index n) {
  const NoiseStream draw(static_cast<std::uint64_t>(number), "box_minimum_test", "problem");
  Tick at = 0;
  const auto next = [&] { return 2.0 * draw.uniform(at++) - 1.0; };
  Eigen::MatrixXd columns(2 * n, n);
  for (Eigen::Index i = 0; i < columns.size(); ++i) {
    columns.data()[i] = next();
  }
  columns.col(0) = columns.col(1) + 1e-3 * columns.col(0);
  Problem problem{columns.transpose() * columns, Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    problem.descent[i] = 10.0 * next();
    problem.low[i] = -0.5 * (1.0 + next());
    problem.high[i] = 0.5 * (1.0 + next());
  }
  return problem;
}

TEST(BoxMinimum, NoSlopeLeadsInwardsAtABoundAndNoneIsLeftElsewhere) {
  int held = 0;
  for (int number = 0; number < 300; ++number) {
    const Problem p = drawn(number, 2 + number % 30);
    const Eigen::VectorXd x = box_minimum(p.normal, p.descent, p.low, p.high);
    const Eigen::VectorXd slope = p.descent - p.normal * x;
    const double flat = 1e-7 * p.descent.lpNorm<Eigen::Infinity>();
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      ASSERT_GE(x[i], p.low[i]);
      ASSERT_LE(x[i], p.high[i]);
      const bool is_low = x[i] == p.low[i];
      const bool is_high = x[i] == p.high[i];
      held += is_low || is_high;
      EXPECT_TRUE(is_high || slope[i] < flat) << "problem " << number << " number " << i;
      EXPECT_TRUE(is_low || slope[i] > -flat) << "problem " << number << " number " << i;
    }
  }
  EXPECT_GT(held, 1000);
}

TEST(BoxMinimum, WithinWideBoundsItIsTheSolutionOfTheLinearSystem) {
  Problem p = drawn(1, 12);
  p.low.setConstant(-1e9);
  p.high.setConstant(1e9);
  const Eigen::VectorXd x = box_minimum(p.normal, p.descent, p.low, p.high);
  EXPECT_LT((p.normal * x - p.descent).norm(), 1e-8 * p.descent.norm());
}

TEST(BoxMinimum, NumbersWithoutRoomStay) {
  Problem p = drawn(2, 5);
  p.low.setZero();
  p.high.setZero();
  EXPECT_EQ(box_minimum(p.normal, p.descent, p.low, p.high), Eigen::VectorXd::Zero(5));
  EXPECT_EQ(box_minimum(Eigen::MatrixXd(0, 0), Eigen::VectorXd(0), Eigen::VectorXd(0), Eigen::VectorXd(0)).size(), 0);
}

}  // namespace box_minimum_test
}  // namespace farrier::diagnosis
