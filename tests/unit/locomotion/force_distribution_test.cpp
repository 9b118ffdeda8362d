#include "locomotion/force_distribution.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "locomotion/rotation.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::locomotion {
namespace force_distribution_test {

constexpr int kCases = 5000;
constexpr double kResidual = 1e-9;  // of the optimality conditions, relative to the largest gradient

// Uniform numbers in [low, high), the same on every machine.
class Draws {
 public:
  double operator()(double low, double high) { return low + (high - low) * stream_.uniform(next_++); }

 private:
  NoiseStream stream_{2014, "force_distribution", "cases"};
  Tick next_ = 0;
};

struct Case {
  Wrench wanted;
  PerLeg<Contact> contacts;
  int count;
};

Case random_case(Draws& draw) {
  Case c;
  c.count = static_cast<int>(draw(1.0, 7.0));
  c.wanted << draw(-400, 400), draw(-400, 400), draw(-200, 1600), draw(-200, 200), draw(-200, 200), draw(-100, 100);
  for (int i = 0; i < c.count; ++i) {
    const Eigen::Vector3d normal{draw(-0.4, 0.4), draw(-0.4, 0.4), 1.0};
    c.contacts[i] = {.lever_m = {draw(-0.6, 0.6), draw(-0.4, 0.4), draw(-0.7, -0.4)},
                     .normal = normal.normalized(),
                     .limit_N = draw(0, 1) < 0.5 ? std::numeric_limits<double>::infinity() : draw(50, 500)};
  }
  return c;
}

// A random problem of the solver itself.
ConeProblem random_problem(Draws& draw) {
  ConeProblem problem;
  problem.cones = static_cast<int>(draw(1.0, 7.0));
  const int n = kEdgesPerCone * problem.cones;
  Eigen::MatrixXd edges = Eigen::MatrixXd::Zero(3 * problem.cones, n);
  for (int i = 0; i < problem.cones; ++i) {
    edges.block<3, 4>(3 * i, 4 * i) << 0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5, -0.5, 1, 1, 1, 1;
    problem.limit[i] = draw(0, 1) < 0.4 ? std::numeric_limits<double>::infinity() : draw(1, 300);
  }
  const Eigen::MatrixXd map = Eigen::MatrixXd::NullaryExpr(6, 3 * problem.cones, [&] { return draw(-1, 1); });
  const Eigen::VectorXd target = Eigen::VectorXd::NullaryExpr(6, [&] { return draw(-1000, 1000); });
  problem.hessian = edges.transpose() * (map.transpose() * map) * edges + 2.5e-3 * edges.transpose() * edges;
  problem.gradient = edges.transpose() * map.transpose() * target;
  return problem;
}

TEST(ConeLeastSquares, SatisfiesTheOptimalityConditionsOfRandomProblems) {
  Draws draw;
  ConeLeastSquares solver;
  int most = 0;
  for (int k = 0; k < kCases; ++k) {
    const ConeProblem problem = random_problem(draw);
    const ConeSolution& s = solver.solve(problem);
    ASSERT_TRUE(s.converged) << "case " << k;
    most = std::max(most, s.iterations);
    const EdgeVector slope = problem.gradient - problem.hessian * s.x;
    const double tolerance = kResidual * problem.gradient.cwiseAbs().maxCoeff();
    for (int cone = 0; cone < problem.cones; ++cone) {
      const double sum = s.x.segment<kEdgesPerCone>(kEdgesPerCone * cone).sum();
      ASSERT_LE(sum, problem.limit[cone] * (1.0 + kResidual));
      ASSERT_GE(s.limit_force[cone], -tolerance);
      if (s.limit_force[cone] > tolerance) {
        ASSERT_NEAR(sum, problem.limit[cone], kResidual * problem.limit[cone]);
      }
      for (int e = kEdgesPerCone * cone; e < kEdgesPerCone * (cone + 1); ++e) {
        ASSERT_GE(s.x[e], 0.0);
        ASSERT_LE(slope[e] - s.limit_force[cone], tolerance) << "case " << k;
        if (s.x[e] > 0.0) {
          ASSERT_NEAR(slope[e], s.limit_force[cone], tolerance) << "case " << k;
        }
      }
    }
  }
  RecordProperty("most_iterations", most);
  EXPECT_LT(most, kMaxConeIterations / 2);
}

// A second route: projected gradient steps on the same problem, which need no active set.
TEST(ConeLeastSquares, AgreesWithProjectedGradientsOnOneFoot) {
  Draws draw;
  ConeLeastSquares solver;
  for (int k = 0; k < 50; ++k) {
    ConeProblem problem = random_problem(draw);
    problem.cones = 1;
    problem.hessian = EdgeMatrix(problem.hessian.topLeftCorner(4, 4));
    problem.gradient = EdgeVector(problem.gradient.head(4));
    problem.limit[0] = std::numeric_limits<double>::infinity();
    const EdgeVector x = solver.solve(problem).x;
    EdgeVector y = EdgeVector::Zero(4);
    const double step = 1.0 / problem.hessian.trace();
    for (int i = 0; i < 200000; ++i) {
      y = (y + step * (problem.gradient - problem.hessian * y)).cwiseMax(0.0);
    }
    const auto cost = [&](const EdgeVector& z) { return 0.5 * z.dot(problem.hessian * z) - problem.gradient.dot(z); };
    EXPECT_LE(cost(x), cost(y) + 1e-6 * std::abs(cost(y)));
    EXPECT_NEAR(cost(x), cost(y), 1e-4 * std::abs(cost(y)) + 1e-9);
  }
}

TEST(ForceDistribution, KeepsFrictionPyramidsAndLimits) {
  Draws draw;
  const ForceDistributionParams params;
  ForceDistribution distribution(params);
  PerLeg<Eigen::Vector3d> forces;
  for (int k = 0; k < kCases; ++k) {
    const Case c = random_case(draw);
    distribution.distribute(c.wanted, c.contacts, c.count, forces);
    for (int i = 0; i < c.count; ++i) {
      const Eigen::Vector3d& n = c.contacts[i].normal;
      const double normal_N = n.dot(forces[i]);
      const double tangent_N = (forces[i] - normal_N * n).norm();
      const double tolerance_N = 1e-9 * c.wanted.norm();
      ASSERT_GE(normal_N, std::min(params.least_N, 0.5 * c.contacts[i].limit_N) - tolerance_N);
      ASSERT_LE(normal_N, c.contacts[i].limit_N + tolerance_N);
      ASSERT_LE(tangent_N, std::sqrt(2.0) * params.friction * normal_N + tolerance_N);
    }
  }
  EXPECT_EQ(distribution.unconverged(), 0);
}

TEST(ForceDistribution, CarriesTheWeightOfAStandingRobotEvenly) {
  ForceDistribution distribution({});
  PerLeg<Contact> contacts;
  for (int i = 0; i < 4; ++i) {
    contacts[i].lever_m = {i < 2 ? 0.37 : -0.37, i % 2 == 0 ? 0.3 : -0.3, -0.58};
  }
  const double weight_N = 84.756 * kGravity_m_s2;
  Wrench wanted = Wrench::Zero();
  wanted[2] = weight_N;
  PerLeg<Eigen::Vector3d> forces;
  distribution.distribute(wanted, contacts, 4, forces);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(forces[i].z(), 0.25 * weight_N, 0.001 * weight_N);  // alpha makes them a little smaller
    EXPECT_NEAR(forces[i].head<2>().norm(), 0.0, 1e-6);
  }
}

TEST(ForceDistribution, AllocatesNothing) {
  Draws draw;
  ForceDistribution distribution({});
  PerLeg<Eigen::Vector3d> forces;
  const Case c = random_case(draw);
  const test::AllocationGuard guard;
  distribution.distribute(c.wanted, c.contacts, c.count, forces);
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(ForceDistribution, GivesNoForceWithoutFeet) {
  ForceDistribution distribution({});
  PerLeg<Eigen::Vector3d> forces;
  distribution.distribute(Wrench::Ones(), {}, 0, forces);
  EXPECT_EQ(distribution.iterations(), 0);
}

}  // namespace force_distribution_test
}  // namespace farrier::locomotion
