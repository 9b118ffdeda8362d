#pragma once

#include <optional>
#include <string>

#include "core/motion.hpp"
#include "core/time.hpp"
#include "ros_messages/messages.hpp"
#include "signals/signals.hpp"
#include "tools/ros/one_sender.hpp"

namespace farrier::ros_bridge {

/// Velocities that one sender asks for, as commands of a walking body. A velocity of zero is a request to stand. It falls
/// silent when the sender does; locomotion then stops by its own rule.
class VelocityCommands {
 public:
  /// `timeout`: age of the newest message beyond which there is no command, and the place is free for another sender.
  explicit VelocityCommands(Nanoseconds timeout) : sender_(timeout) {}

  /// Takes a message of `sender`. Returns why it is refused: a number that is not finite, a velocity that no body can
  /// have in its plane, or another sender whose newest message is not too old. Empty: taken.
  std::string take(const ros_messages::geometry_msgs::Twist& twist, std::uint64_t sender, SteadyTime now);

  /// The command at this time, without session, tick and count. None if the newest message is too old, and at a velocity
  /// of zero while the robot lies: it stands up for a velocity alone.
  std::optional<signals::BodyCommand> command(SteadyTime now, MotionMode mode) const;

 private:
  OneSender sender_;
  ros_messages::geometry_msgs::Twist newest_;
};

}  // namespace farrier::ros_bridge
