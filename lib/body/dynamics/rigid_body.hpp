#pragma once

// Kinematics and dynamics of a robot with a free trunk. Its equations of motion, and the acceleration of foot i:
//
//   M(q) v' + c(q, v) = S' tau + sum over feet J_i(q)' f_i
//   a_i = J_i v' + (dJ_i/dt) v.
//
// Here v is the generalised velocity of BodyState, tau the joint torques and f_i the force of the ground on foot i, in
// the world's axes. Function set_state() computes all links' motion, and the other functions read it.

#include <array>

#include "body/dynamics/spatial.hpp"
#include "body/model/body_model.hpp"
#include "body/model/body_state.hpp"

namespace farrier::body {

/// Rigid-body algorithms on one robot. No function allocates after create(). The numbers come from +, -, *, / and sqrt
/// alone, so they are the same bits on every processor of an architecture.
class RigidBody {
 public:
  /// At rest in BodyState::zero. Refuses a model that validate() refuses.
  static Result<RigidBody> create(const BodyModel& model);

  int legs() const noexcept { return legs_; }
  int joints() const noexcept { return kJointsPerLeg * legs_; }
  /// n, the length of a generalised velocity.
  int velocities() const noexcept { return kTrunkVelocities + joints(); }

  /// Positions and velocities of all links. An angle outside [-8, 8] rad or a number that is not finite makes the
  /// results NaN. Vectors of `state` have joints() entries.
  void set_state(const BodyState& state) noexcept;

  /// Point on the axis of a joint, where its link begins, in the world. `index`: 0..kJointsPerLeg - 1 from the trunk on.
  Eigen::Vector3d hinge_position_m(int leg, int index) const noexcept {
    return position_m_ + link_of(leg, index).hinge_m;
  }

  /// Centre of the foot's sphere, in the world.
  Eigen::Vector3d foot_position_m(int leg) const noexcept;
  Eigen::Vector3d foot_velocity_m_s(int leg) const noexcept;

  /// Angular velocity of the link with the foot, in the world's axes.
  Eigen::Vector3d last_link_rate_rad_s(int leg) const noexcept {
    return link_of(leg, kJointsPerLeg - 1).velocity.angular;
  }

  /// J, 3 x n: foot velocity = J v, in the world's axes.
  FootJacobian foot_jacobian(int leg) const noexcept;

  /// (dJ/dt) v, m/s^2: the acceleration of the foot's centre while v' is zero.
  Eigen::Vector3d foot_jacobian_rate_times_velocity_m_s2(int leg) const noexcept;

  /// M, symmetric and positive definite, with armatures on its diagonal: the composite-rigid-body algorithm
  /// (Featherstone 2008, section 6.2).
  MassMatrix mass_matrix() const noexcept;

  /// c, the generalised force of v' = 0 under gravity: the recursive Newton-Euler algorithm (Featherstone 2008, section
  /// 5.3). Joint damping is not part of it.
  VelocityVector bias_forces() const noexcept;

  /// Centre of mass of the whole robot, in the world.
  Eigen::Vector3d centre_of_mass_m() const noexcept;

  /// v' M v / 2, armatures included.
  double kinetic_energy_J() const noexcept;
  /// Against the world's plane z = 0.
  double potential_energy_J() const noexcept;

  double total_mass_kg() const noexcept { return total_mass_kg_; }

 private:
  // A link in the shared frame of spatial.hpp.
  struct MovedLink {
    Eigen::Matrix3d rotation;  // from the link's axes to the world's
    Eigen::Vector3d hinge_m;   // from the trunk's origin
    Motion axis;               // spatial: the velocity that a joint velocity of 1 rad/s adds
    Motion velocity;
    Motion bias_acceleration;  // for v' = 0, without gravity
    SpatialInertia inertia;
    double joint_velocity_rad_s;
  };

  explicit RigidBody(const BodyModel& model);
  void move_trunk(const BodyState& state) noexcept;
  void move_link(const Link& link, const MovedLink* parent, double angle_rad, double velocity_rad_s,
                 MovedLink& moved) noexcept;
  Eigen::Vector3d foot_from_trunk_m(int leg) const noexcept;
  const MovedLink& link_of(int leg, int index) const noexcept { return links_[kJointsPerLeg * leg + index]; }
  Motion with_gravity(const Motion& acceleration) const noexcept;
  SpatialInertia total_inertia() const noexcept;

  int legs_;
  double gravity_m_s2_;
  double total_mass_kg_;
  RigidInertia trunk_data_;
  std::array<Link, kMaxJoints> link_data_;
  std::array<Eigen::Vector3d, kMaxLegs> foot_data_m_;

  Eigen::Vector3d position_m_;
  Eigen::Matrix3d rotation_;
  Motion trunk_velocity_;
  Motion trunk_bias_acceleration_;
  SpatialInertia trunk_inertia_;
  std::array<MovedLink, kMaxJoints> links_;
};

}  // namespace farrier::body
