#include <gtest/gtest.h>

#include "control/numerics/riccati.hpp"
#include "models.hpp"
#include "bench/slicot.hpp"

namespace farrier::control {
namespace riccati_slicot_test {

template <int N>
void expect_agreement(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                      const Eigen::Matrix<double, N, N>& q, double r) {
  const auto ours = solve_dare<N>(a, b, q, r, Eigen::Matrix<double, N, 1>::Zero());
  ASSERT_TRUE(ours.ok()) << to_string(ours.error());
  Eigen::Matrix<double, N, N> theirs;
  ASSERT_TRUE((bench::solve_dare_by_slicot<N>(a, b, q, r, theirs)));
  // SLICOT solves X U11 = U21 once, without refinement: its error is its own residual over 1 - rho^2.
  const double residual =
      riccati_residual<N>(a, b, q, r, Eigen::Matrix<double, N, 1>::Zero(), theirs).norm() / theirs.norm();
  const double rho = spectral_radius(a - b * ours.value().k);
  const double tolerance = 10.0 * (residual + 1e-14) / (1.0 - rho * rho);
  EXPECT_LT(residual, 1e-9);
  EXPECT_LT((ours.value().s - theirs).norm(), tolerance * theirs.norm()) << ours.value().s << "\n\n" << theirs;
}

TEST(RiccatiSlicot, AgreesOnTheForceModelOfTheThesis) {
  for (const double mass_kg : {0.5, 2.5, 50.0}) {
    const DiscreteModel plant = normalise(testing::sampled(testing::fc1d(mass_kg)), testing::kNormalisation);
    Eigen::Matrix4d a = Eigen::Matrix4d::Identity();
    a(0, 3) = -1.0;
    a.bottomRightCorner<3, 3>() = plant.a;
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    b.tail<3>() = plant.b;
    const Eigen::Matrix4d q = Eigen::Vector4d(2.5, 1.0, 1.0, 5000.0).asDiagonal();
    expect_agreement<4>(a, b, q, 0.1);
  }
}

TEST(RiccatiSlicot, AgreesOnRandomSystems) {
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix<double, 6, 6> a = 0.5 * testing::random_matrix<Eigen::Matrix<double, 6, 6>>("sa", i);
    const auto b = testing::random_matrix<Eigen::Matrix<double, 6, 1>>("sb", i);
    const auto g = testing::random_matrix<Eigen::Matrix<double, 6, 6>>("sg", i);
    expect_agreement<6>(a, b, g * g.transpose(), 1.0);
  }
}

}  // namespace riccati_slicot_test
}  // namespace farrier::control
