#include "body/dynamics/rigid_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "tests/support/allocation_guard.hpp"
#include "test_bodies.hpp"

namespace farrier::body {
namespace rigid_body_test {

constexpr int kPoses = 50;
// Central differences over kStep_s: the truncation is about 1e-8 of third derivatives up to 1e3, the rounding 1e-10.
constexpr double kStep_s = 1e-5;
constexpr double kDifference = 1e-6;
constexpr double kRounding = 1e-11;

class AnyBody : public testing::TestWithParam<int> {
 protected:
  AnyBody() : model_(random_body(GetParam(), 7)), body_(RigidBody::create(model_).value()) {}

  RigidBody at(const BodyState& state) const {
    RigidBody body = body_;
    body.set_state(state);
    return body;
  }

  BodyModel model_;
  RigidBody body_;
};

TEST_P(AnyBody, JacobianTimesVelocityIsTheFootsVelocity) {
  Draws draws(1);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body_.joints(), draws);
    body_.set_state(state);
    for (int leg = 0; leg < body_.legs(); ++leg) {
      const Eigen::Vector3d difference =
          (at(moved(state, kStep_s)).foot_position_m(leg) - at(moved(state, -kStep_s)).foot_position_m(leg)) /
          (2.0 * kStep_s);
      const Eigen::Vector3d velocity = body_.foot_jacobian(leg) * state.velocity();
      EXPECT_LT((velocity - difference).norm(), kDifference * (1.0 + velocity.norm()));
      EXPECT_LT((velocity - body_.foot_velocity_m_s(leg)).norm(), kRounding);
    }
  }
}

TEST_P(AnyBody, JacobianRateIsThatOfTheJacobianAlongTheMotion) {
  Draws draws(2);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body_.joints(), draws);
    body_.set_state(state);
    for (int leg = 0; leg < body_.legs(); ++leg) {
      const Eigen::Vector3d difference = (at(moved(state, kStep_s)).foot_jacobian(leg) * state.velocity() -
                                          at(moved(state, -kStep_s)).foot_jacobian(leg) * state.velocity()) /
                                         (2.0 * kStep_s);
      const Eigen::Vector3d rate = body_.foot_jacobian_rate_times_velocity_m_s2(leg);
      EXPECT_LT((rate - difference).norm(), kDifference * (1.0 + rate.norm()));
    }
  }
}

TEST_P(AnyBody, MassMatrixIsSymmetricAndPositiveDefinite) {
  Draws draws(3);
  for (int pose = 0; pose < kPoses; ++pose) {
    body_.set_state(random_state(body_.joints(), draws));
    const MassMatrix m = body_.mass_matrix();
    EXPECT_LT((m - m.transpose()).cwiseAbs().maxCoeff(), kRounding);
    EXPECT_EQ(m.llt().info(), Eigen::Success);
  }
}

TEST_P(AnyBody, MassMatrixGivesTheKineticEnergyOfTheLinks) {
  Draws draws(4);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body_.joints(), draws);
    body_.set_state(state);
    const VelocityVector v = state.velocity();
    const double energy_J = 0.5 * v.dot(body_.mass_matrix() * v);
    EXPECT_NEAR(body_.kinetic_energy_J(), energy_J, kRounding * energy_J);
  }
}

// With no force the energy is constant. Along v' = -M^-1 c the power of gravity and inertia must cancel:
//   d/dt (v' M v / 2 + V) = 0.
TEST_P(AnyBody, BiasForcesKeepTheEnergy) {
  Draws draws(5);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body_.joints(), draws);
    body_.set_state(state);
    const VelocityVector acceleration = body_.mass_matrix().llt().solve(-body_.bias_forces());
    const auto energy_J = [&](double time_s) {
      BodyState later = moved(state, time_s);
      const VelocityVector v = state.velocity() + time_s * acceleration;
      later.linear_velocity_m_s = v.head<3>();
      later.angular_velocity_rad_s = v.segment<3>(3);
      later.velocities_rad_s = v.tail(body_.joints());
      const RigidBody there = at(later);
      return there.kinetic_energy_J() + there.potential_energy_J();
    };
    const double power_W = (energy_J(kStep_s) - energy_J(-kStep_s)) / (2.0 * kStep_s);
    EXPECT_NEAR(power_W, 0.0, kDifference * body_.kinetic_energy_J() / 1e-2);
  }
}

TEST_P(AnyBody, FallsWithGravity) {
  Draws draws(6);
  BodyState state = random_state(body_.joints(), draws);
  state.linear_velocity_m_s.setZero();
  state.angular_velocity_rad_s.setZero();
  state.velocities_rad_s.setZero();
  body_.set_state(state);
  const VelocityVector acceleration = body_.mass_matrix().llt().solve(-body_.bias_forces());
  VelocityVector fall = VelocityVector::Zero(body_.velocities());
  fall[2] = -model_.gravity_m_s2;
  EXPECT_LT((acceleration - fall).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_P(AnyBody, AllocatesNothingAfterItsCreation) {
  Draws draws(8);
  const BodyState state = random_state(body_.joints(), draws);
  const test::AllocationGuard guard;
  body_.set_state(state);
  double sum = body_.mass_matrix().sum() + body_.bias_forces().sum() + body_.centre_of_mass_m().sum();
  for (int leg = 0; leg < body_.legs(); ++leg) {
    sum += body_.foot_jacobian(leg).sum() + body_.foot_jacobian_rate_times_velocity_m_s2(leg).sum();
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(sum));
}

TEST_P(AnyBody, AnswersNaNToAnAngleOutOfRange) {
  BodyState state = BodyState::zero(body_.joints());
  state.angles_rad[0] = 1.1e6;
  body_.set_state(state);
  EXPECT_TRUE(std::isnan(body_.foot_position_m(0).sum()));
}

INSTANTIATE_TEST_SUITE_P(Legs, AnyBody, testing::Values(1, 2, 4, 6));

TEST(RigidBody, RefusesWhatTheModelsCheckRefuses) {
  BodyModel model = random_body(2, 1);
  model.trunk.mass_kg = -1.0;
  const auto body = RigidBody::create(model);
  ASSERT_FALSE(body.ok());
  EXPECT_EQ(body.error().message, "the trunk has no mass: give its mass in kg, above zero");
}

}  // namespace rigid_body_test
}  // namespace farrier::body
