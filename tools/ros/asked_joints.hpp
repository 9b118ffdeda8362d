#pragma once

#include <optional>
#include <vector>

#include "core/result.hpp"
#include "robot/robot.hpp"
#include "ros_messages/messages.hpp"

namespace farrier::ros_bridge {

/// A message's command of one joint. Without a value: it is not commanded, which NaN and a missing interface say.
struct AskedJoint {
  std::optional<double> position_rad, velocity_rad_s, effort_Nm, stiffness_Nm_rad, damping_Nms_rad;

  bool empty() const noexcept { return !position_rad && !velocity_rad_s && !effort_Nm; }
};

/// Largest stiffness and damping that a message may ask for, as a multiple of the joint's own in the robot file.
inline constexpr double kMostGains = 10.0;

/// Commands by joint number of a message that ros2_control's topic-based system sends. Each array has the length of `name`
/// or none. Refuses other lengths, unknown and repeated names, and infinite numbers.
Result<std::vector<AskedJoint>> asked_joints(const robot::Robot& robot,
                                             const ros_messages::sensor_msgs::JointState& message);

/// The same of a message with the interfaces position, velocity, effort, kp or proportional, and kd or derivative. Also
/// refuses other interfaces, and gains below 0 or above kMostGains.
Result<std::vector<AskedJoint>> asked_joints(const robot::Robot& robot,
                                             const ros_messages::control_msgs::DynamicJointState& message);

}  // namespace farrier::ros_bridge
