#include "robot/locomotion_model.hpp"

namespace farrier::robot {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Rotation from the trunk to a world whose z axis points against gravity. Its heading does not matter: the results are
// turned back into the trunk's axes.
Matrix3d world_from_trunk(const Vector3d& gravity) noexcept {
  const Vector3d up = -gravity.normalized();
  const Vector3d across = up.cross(up.x() * up.x() < 0.5 ? Vector3d::UnitX() : Vector3d::UnitY()).normalized();
  Matrix3d rotation;
  rotation.row(0) = across.cross(up).transpose();
  rotation.row(1) = across.transpose();
  rotation.row(2) = up.transpose();
  return rotation;
}

// The trunk of `body` turns with w, its origin is at rest in the world's.
void put_leg(const body::RigidBody& body, const Matrix3d& to_trunk, const Vector3d& w, int number,
             const locomotion::LegReadings& readings, locomotion::LegState& leg) noexcept {
  const int first = body::kTrunkVelocities + body::kJointsPerLeg * number;
  leg.foot_m = to_trunk * body.foot_position_m(number);
  leg.jacobian = to_trunk * body.foot_jacobian(number).middleCols<body::kJointsPerLeg>(first);
  leg.foot_velocity_m_s = leg.jacobian * readings.velocity_rad_s;
  leg.shank_rate_rad_s = to_trunk * body.last_link_rate_rad_s(number) - w;
  // Acceleration of a point that moves in a turning frame: a = w x (w x s) + 2 w x s' + J' q'.
  leg.foot_bias_m_s2 = to_trunk * body.foot_jacobian_rate_times_velocity_m_s2(number) - w.cross(w.cross(leg.foot_m)) -
                       2.0 * w.cross(leg.foot_velocity_m_s);
}

}  // namespace

Result<LocomotionModel> LocomotionModel::create(const body::BodyModel& model) {
  const body::RigidBody body = FARRIER_TRY(body::RigidBody::create(model));
  body::JointVector damping_Nms_rad = body::JointVector::Zero(model.joints());
  for (int joint = 0; joint < model.joints(); ++joint) {
    damping_Nms_rad[joint] =
        model.legs[joint / body::kJointsPerLeg].links[joint % body::kJointsPerLeg].known_damping_Nms_rad;
  }
  return LocomotionModel(body, damping_Nms_rad);
}

void LocomotionModel::update(std::span<const locomotion::LegReadings> legs, const locomotion::TrunkMotion& trunk,
                             locomotion::BodyState& state) const noexcept {
  const Matrix3d rotation = world_from_trunk(trunk.gravity_m_s2);
  moved_.attitude = Eigen::Quaterniond(rotation);
  moved_.angular_velocity_rad_s = trunk.angular_velocity_rad_s;
  for (int leg = 0; leg < body_.legs(); ++leg) {
    moved_.angles_rad.segment<body::kJointsPerLeg>(body::kJointsPerLeg * leg) = legs[leg].position_rad;
    moved_.velocities_rad_s.segment<body::kJointsPerLeg>(body::kJointsPerLeg * leg) = legs[leg].velocity_rad_s;
  }
  body_.set_state(moved_);
  const Matrix3d to_trunk = rotation.transpose();
  const body::MassMatrix inertia = body_.mass_matrix();
  body::VelocityVector bias = body_.bias_forces();
  bias.tail(body_.joints()) += damping_Nms_rad_.cwiseProduct(moved_.velocities_rad_s);
  for (int leg = 0; leg < body_.legs(); ++leg) {
    put_leg(body_, to_trunk, trunk.angular_velocity_rad_s, leg, legs[leg], state.legs[leg]);
    const int first = body::kTrunkVelocities + body::kJointsPerLeg * leg;
    state.legs[leg].inertia_kg_m2 = inertia.block<body::kJointsPerLeg, body::kJointsPerLeg>(first, first);
    state.legs[leg].bias_torque_Nm = bias.segment<body::kJointsPerLeg>(first);
  }
  state.com_m = to_trunk * body_.centre_of_mass_m();
}

}  // namespace farrier::robot
