#include "body/dynamics/rigid_body.hpp"

#include "core/portable_math.hpp"

namespace farrier::body {
namespace {

// Rodrigues' formula for an axis a of unit length: R = cos q 1 + (1 - cos q) a a' + sin q [a]x.
Eigen::Matrix3d rotation_about(const Eigen::Vector3d& a, double angle_rad) noexcept {
  const portable::SineCosine q = portable::sincos(angle_rad);
  Eigen::Matrix3d cross_matrix;
  cross_matrix << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return q.cosine * Eigen::Matrix3d::Identity() + (1.0 - q.cosine) * a * a.transpose() + q.sine * cross_matrix;
}

SpatialInertia moved(const RigidInertia& inertia, const Eigen::Matrix3d& rotation, const Eigen::Vector3d& origin_m) {
  return SpatialInertia::of(inertia.mass_kg, origin_m + rotation * inertia.com_m,
                            rotation * inertia.tensor_kg_m2 * rotation.transpose());
}

}  // namespace

RigidBody::RigidBody(const BodyModel& model)
    : legs_(static_cast<int>(model.legs.size())),
      gravity_m_s2_(model.gravity_m_s2),
      total_mass_kg_(body::total_mass_kg(model)),
      trunk_data_(model.trunk) {
  std::size_t joint = 0;
  for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
    foot_data_m_[leg] = model.legs[leg].foot_m;
    for (const Link& link : model.legs[leg].links) {
      link_data_[joint] = link;
      link_data_[joint].axis.normalize();
      ++joint;
    }
  }
  set_state(BodyState::zero(joints()));
}

Result<RigidBody> RigidBody::create(const BodyModel& model) {
  FARRIER_TRY(validate(model));
  return RigidBody(model);
}

void RigidBody::set_state(const BodyState& state) noexcept {
  move_trunk(state);
  for (int joint = 0; joint < joints(); ++joint) {
    const MovedLink* parent = joint % kJointsPerLeg == 0 ? nullptr : &links_[joint - 1];
    move_link(link_data_[joint], parent, state.angles_rad[joint], state.velocities_rad_s[joint], links_[joint]);
  }
}

// The trunk's origin is the frame's, so its spatial velocity is (w, v). With v' = 0 the origin has no acceleration, and
// the spatial one is that of a fixed point which the trunk passes: -w x v (Featherstone 2008, section 2.11).
void RigidBody::move_trunk(const BodyState& state) noexcept {
  position_m_ = state.position_m;
  rotation_ = state.attitude.toRotationMatrix();
  trunk_velocity_.angular = rotation_ * state.angular_velocity_rad_s;
  trunk_velocity_.linear = state.linear_velocity_m_s;
  trunk_bias_acceleration_.linear = -trunk_velocity_.angular.cross(trunk_velocity_.linear);
  trunk_inertia_ = moved(trunk_data_, rotation_, Eigen::Vector3d::Zero());
}

// Outward pass of Featherstone (2008), section 5.3:  v_i = v_p + s_i q'_i,   a_i = a_p + v_i x s_i q'_i.
void RigidBody::move_link(const Link& link, const MovedLink* parent, double angle_rad, double velocity_rad_s,
                          MovedLink& out) noexcept {
  const Eigen::Matrix3d& parent_rotation = parent != nullptr ? parent->rotation : rotation_;
  const Motion& parent_velocity = parent != nullptr ? parent->velocity : trunk_velocity_;
  const Motion& parent_acceleration = parent != nullptr ? parent->bias_acceleration : trunk_bias_acceleration_;

  out.hinge_m = parent_rotation * link.hinge_m;
  if (parent != nullptr) {
    out.hinge_m += parent->hinge_m;
  }
  out.rotation = parent_rotation * rotation_about(link.axis, angle_rad);
  out.axis.angular = parent_rotation * link.axis;
  out.axis.linear = out.hinge_m.cross(out.axis.angular);  // of the point at the origin: -a x p
  out.joint_velocity_rad_s = velocity_rad_s;
  const Motion of_joint = out.axis * velocity_rad_s;
  out.velocity = parent_velocity + of_joint;
  out.bias_acceleration = parent_acceleration + cross(out.velocity, of_joint);
  out.inertia = moved(link.inertia, out.rotation, out.hinge_m);
}

Eigen::Vector3d RigidBody::foot_from_trunk_m(int leg) const noexcept {
  const MovedLink& last = link_of(leg, kJointsPerLeg - 1);
  return last.hinge_m + last.rotation * foot_data_m_[leg];
}

Eigen::Vector3d RigidBody::foot_position_m(int leg) const noexcept { return position_m_ + foot_from_trunk_m(leg); }

Eigen::Vector3d RigidBody::foot_velocity_m_s(int leg) const noexcept {
  const Motion& v = link_of(leg, kJointsPerLeg - 1).velocity;
  return v.linear + v.angular.cross(foot_from_trunk_m(leg));
}

FootJacobian RigidBody::foot_jacobian(int leg) const noexcept {
  FootJacobian jacobian = FootJacobian::Zero(3, velocities());
  const Eigen::Vector3d foot_m = foot_from_trunk_m(leg);
  jacobian.leftCols<3>().setIdentity();
  for (int axis = 0; axis < 3; ++axis) {
    jacobian.col(3 + axis) = rotation_.col(axis).cross(foot_m);
  }
  for (int i = 0; i < kJointsPerLeg; ++i) {
    const MovedLink& link = link_of(leg, i);
    jacobian.col(kTrunkVelocities + kJointsPerLeg * leg + i) = link.axis.angular.cross(foot_m - link.hinge_m);
  }
  return jacobian;
}

// The acceleration of a point of a body from the spatial one: a + w' x p + w x (v + w x p).
Eigen::Vector3d RigidBody::foot_jacobian_rate_times_velocity_m_s2(int leg) const noexcept {
  const MovedLink& last = link_of(leg, kJointsPerLeg - 1);
  const Motion& a = last.bias_acceleration;
  return a.linear + a.angular.cross(foot_from_trunk_m(leg)) + last.velocity.angular.cross(foot_velocity_m_s(leg));
}

// M_ij = s_j' I_i s_i for each joint j between joint i and the trunk, where I_i is the inertia of link i with all that it
// carries. The trunk's columns are unit velocities along the world's axes and about its own.
MassMatrix RigidBody::mass_matrix() const noexcept {
  MassMatrix m = MassMatrix::Zero(velocities(), velocities());
  for (int leg = 0; leg < legs_; ++leg) {
    SpatialInertia carried;
    for (int i = kJointsPerLeg - 1; i >= 0; --i) {
      const MovedLink& link = link_of(leg, i);
      const int row = kTrunkVelocities + kJointsPerLeg * leg + i;
      carried = carried + link.inertia;
      const Force force = carried * link.axis;
      for (int j = 0; j <= i; ++j) {
        const int column = kTrunkVelocities + kJointsPerLeg * leg + j;
        m(row, column) = power(link_of(leg, j).axis, force);
        m(column, row) = m(row, column);
      }
      m(row, row) += link_data_[kJointsPerLeg * leg + i].armature_kg_m2;
      m.block<3, 1>(0, row) = force.linear;
      m.block<3, 1>(3, row) = rotation_.transpose() * force.moment;
      m.block<1, 6>(row, 0) = m.block<6, 1>(0, row).transpose();
    }
  }
  const SpatialInertia total = total_inertia();
  m.topLeftCorner<3, 3>() = total.mass_kg * Eigen::Matrix3d::Identity();
  m.block<3, 3>(3, 3) = rotation_.transpose() * total.tensor_kg_m2 * rotation_;
  for (int axis = 0; axis < 3; ++axis) {
    m.block<3, 1>(0, 3 + axis) = rotation_.col(axis).cross(total.first_moment_kg_m);
  }
  m.block<3, 3>(3, 0) = m.block<3, 3>(0, 3).transpose();
  return m;
}

// Gravity acts like an acceleration of the world upwards (Featherstone 2008, section 5.3).
Motion RigidBody::with_gravity(const Motion& acceleration) const noexcept {
  return {acceleration.angular, acceleration.linear + gravity_m_s2_ * Eigen::Vector3d::UnitZ()};
}

// Inward pass of section 5.3:  f_i = I_i a_i + v_i x* I_i v_i + sum of the forces on its children,   tau_i = s_i' f_i.
VelocityVector RigidBody::bias_forces() const noexcept {
  VelocityVector bias(velocities());
  Force total = trunk_inertia_ * with_gravity(trunk_bias_acceleration_) +
                cross(trunk_velocity_, trunk_inertia_ * trunk_velocity_);
  for (int leg = 0; leg < legs_; ++leg) {
    Force carried;
    for (int i = kJointsPerLeg - 1; i >= 0; --i) {
      const MovedLink& link = link_of(leg, i);
      carried = carried + link.inertia * with_gravity(link.bias_acceleration) +
                cross(link.velocity, link.inertia * link.velocity);
      bias[kTrunkVelocities + kJointsPerLeg * leg + i] = power(link.axis, carried);
    }
    total = total + carried;
  }
  bias.head<3>() = total.linear;
  bias.segment<3>(3) = rotation_.transpose() * total.moment;
  return bias;
}

SpatialInertia RigidBody::total_inertia() const noexcept {
  SpatialInertia total = trunk_inertia_;
  for (int joint = 0; joint < joints(); ++joint) {
    total = total + links_[joint].inertia;
  }
  return total;
}

Eigen::Vector3d RigidBody::centre_of_mass_m() const noexcept {
  const SpatialInertia total = total_inertia();
  return position_m_ + total.first_moment_kg_m / total.mass_kg;
}

double RigidBody::kinetic_energy_J() const noexcept {
  double twice = power(trunk_velocity_, trunk_inertia_ * trunk_velocity_);
  for (int joint = 0; joint < joints(); ++joint) {
    const MovedLink& link = links_[joint];
    twice += power(link.velocity, link.inertia * link.velocity) +
             link_data_[joint].armature_kg_m2 * link.joint_velocity_rad_s * link.joint_velocity_rad_s;
  }
  return 0.5 * twice;
}

double RigidBody::potential_energy_J() const noexcept {
  return total_mass_kg_ * gravity_m_s2_ * centre_of_mass_m().z();
}

}  // namespace farrier::body
