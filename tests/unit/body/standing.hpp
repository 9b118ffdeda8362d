#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "body/dynamics/rigid_body.hpp"
#include "body/engine/engine.hpp"
#include "robot/robot.hpp"

namespace farrier::body {

inline robot::Robot load_hyq() {
  auto robot = robot::load_robot(FARRIER_ROBOTS "hyq.yaml");
  EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
  return std::move(robot).value();
}

/// All joints at home, feet on the plane z = 0, at rest.
inline BodyState standing_state(const robot::Robot& robot, RigidBody& body) {
  BodyState state = BodyState::zero(body.joints());
  for (int joint = 0; joint < body.joints(); ++joint) {
    state.angles_rad[joint] = robot.joints[static_cast<std::size_t>(joint)].home_angle_rad;
  }
  body.set_state(state);
  state.position_m.z() = robot.body->legs[0].foot_radius_m - body.foot_position_m(0).z();
  body.set_state(state);
  return state;
}

/// Holds each joint at an angle and carries the robot's weight on vertical forces f_i. Its torques are the joints' part of
///   tau = c - sum of J_i' f_i + k_p (q_0 - q) - k_d q'.
class StanceController {
 public:
  StanceController(const RigidBody& standing, const BodyState& state, double mass_kg, double gravity_m_s2)
      : angles_rad_(state.angles_rad) {
    const double front_m = standing.foot_position_m(0).x();
    const double hind_m = standing.foot_position_m(2).x();
    const double share = (standing.centre_of_mass_m().x() - hind_m) / (front_m - hind_m);
    const double half_N = 0.5 * mass_kg * gravity_m_s2;
    front_N_ = share * half_N;
    hind_N_ = half_N - front_N_;
  }

  double force_N(int leg) const noexcept { return leg < 2 ? front_N_ : hind_N_; }

  JointVector torques_Nm(const RigidBody& body, const BodyState& state) const noexcept {
    constexpr double kStiffness_Nm_rad = 2000.0;
    constexpr double kDamping_Nms_rad = 40.0;
    VelocityVector forces = body.bias_forces();
    for (int leg = 0; leg < body.legs(); ++leg) {
      forces -= body.foot_jacobian(leg).transpose() * Eigen::Vector3d(0.0, 0.0, force_N(leg));
    }
    return forces.tail(body.joints()) + kStiffness_Nm_rad * (angles_rad_ - state.angles_rad) -
           kDamping_Nms_rad * state.velocities_rad_s;
  }

 private:
  JointVector angles_rad_;
  double front_N_;
  double hind_N_;
};

}  // namespace farrier::body
