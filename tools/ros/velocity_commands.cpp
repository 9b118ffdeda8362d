#include "tools/ros/velocity_commands.hpp"

#include <cmath>

namespace farrier::ros_bridge {

std::string VelocityCommands::take(const ros_messages::geometry_msgs::Twist& twist, std::uint64_t sender,
                                   SteadyTime now) {
  for (const double number :
       {twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.x, twist.angular.y, twist.angular.z}) {
    if (!std::isfinite(number)) {
      return "cmd_vel with a number that is not finite";
    }
  }
  if (twist.linear.z != 0.0 || twist.angular.x != 0.0 || twist.angular.y != 0.0) {
    return "cmd_vel with linear.z, angular.x or angular.y: give linear.x, linear.y and angular.z alone";
  }
  if (sender_.taken_by_another(sender, now)) {
    return std::string("cmd_vel") + kSecondSender;
  }
  newest_ = twist;
  sender_.heard(sender, now);
  return "";
}

std::optional<signals::BodyCommand> VelocityCommands::command(SteadyTime now, MotionMode mode) const {
  if (sender_.silent(now)) {
    return std::nullopt;
  }
  const bool stands = newest_.linear.x == 0.0 && newest_.linear.y == 0.0 && newest_.angular.z == 0.0;
  if (stands && (mode == MotionMode::kLie || mode == MotionMode::kSitDown || mode == MotionMode::kFallen)) {
    return std::nullopt;
  }
  signals::BodyCommand command;
  command.request = stands ? MotionRequest::kStand : MotionRequest::kTrot;
  command.forward_m_s = newest_.linear.x;
  command.left_m_s = newest_.linear.y;
  command.yaw_rate_rad_s = newest_.angular.z;
  return command;
}

}  // namespace farrier::ros_bridge
