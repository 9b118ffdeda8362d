#include "trials/body/stand.hpp"

#include "body/dynamics/rigid_body.hpp"

namespace farrier::trials {

Result<Stand> Stand::create(const robot::Robot& robot, const Gains& gains) {
  if (!robot.body) {
    return Error{robot.name + " is not described as rigid bodies: give body.trunk in its file"};
  }
  auto body = FARRIER_TRY(body::RigidBody::create(*robot.body));
  body::BodyState home = body::BodyState::zero(body.joints());
  Stand stand;
  stand.gains_ = gains;
  for (const robot::Joint& joint : robot.joints) {
    home.angles_rad[joint.number] = joint.home_angle_rad;
    stand.home_rad_.push_back(joint.home_angle_rad);
  }
  body.set_state(home);
  const double share_N = body.total_mass_kg() * robot.body->gravity_m_s2 / body.legs();
  for (int leg = 0; leg < body.legs(); ++leg) {
    const body::FootJacobian jacobian = body.foot_jacobian(leg);
    for (int i = 0; i < body::kJointsPerLeg; ++i) {
      const int column = body::kTrunkVelocities + body::kJointsPerLeg * leg + i;
      stand.feed_forward_Nm_.push_back(-share_N * jacobian(2, column));
    }
  }
  return stand;
}

void Stand::step(const world::World& world, std::span<double> torques_Nm) noexcept {
  for (std::size_t joint = 0; joint < torques_Nm.size(); ++joint) {
    const world::JointReading reading = world.reading(joint);
    torques_Nm[joint] = feed_forward_Nm_[joint] + gains_.stiffness_Nm_rad * (home_rad_[joint] - reading.position) -
                        gains_.damping_Nms_rad * reading.velocity;
  }
}

}  // namespace farrier::trials
