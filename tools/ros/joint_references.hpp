#pragma once

#include <span>
#include <string>
#include <vector>

#include "tools/ros/asked_joints.hpp"
#include "tools/ros/one_sender.hpp"

namespace farrier::ros_bridge {

/// A joint as it is now.
struct JointNow {
  std::optional<double> angle_rad;  ///< measured; none: not heard
  bool follows = false;             ///< it is armed and has not tripped
};

/// Reference of one joint: that of joint/command.
struct JointReference {
  double position_rad, velocity_rad_s, torque_ff_Nm, stiffness_Nm_rad, damping_Nms_rad;
};

/// The joints' references as one sender of ROS commands them.
///
/// A joint that is not commanded holds its position with the impedance of the robot file. The position is that of its last
/// command, or the measured one. Stiffness acts on a commanded position alone, and damping on a commanded position or
/// velocity. An effort alone is a torque.
///
/// Some commands must begin within kNear_rad of the measured angle. They are the first one after a silence, one of a joint
/// that was commanded no position, and each one while the joint does not follow.
class JointReferences {
 public:
  static constexpr double kNear_rad = 0.2;

  /// `timeout`: age of the newest message beyond which there is no reference, and the place is free for another sender.
  /// `robot` must outlive it.
  JointReferences(const robot::Robot& robot, Nanoseconds timeout);

  /// Takes a message; `joints` by number. Returns why it is refused, in a sentence that begins with `topic`; empty: taken.
  /// A refused message changes nothing.
  template <class Message>
  std::string take(const char* topic, const Message& message, std::uint64_t sender, SteadyTime now,
                   std::span<const JointNow> joints) {
    if (sender_.taken_by_another(sender, now)) {
      return std::string(topic) + kSecondSender;
    }
    const auto asked = asked_joints(robot_, message);
    const std::string refusal = asked ? apply(asked.value(), sender, now, joints) : asked.error().message;
    return refusal.empty() ? "" : std::string(topic) + ": " + refusal;
  }

  /// By joint number; empty while the sender is silent.
  std::span<const JointReference> references(SteadyTime now) const;

  /// The next message is a first one.
  void forget() noexcept { sender_.forget(); }

 private:
  std::string apply(const std::vector<AskedJoint>& asked, std::uint64_t sender, SteadyTime now,
                    std::span<const JointNow> joints);

  const robot::Robot& robot_;
  OneSender sender_;
  std::vector<JointReference> references_;  ///< by number
  std::vector<bool> positioned_;            ///< by number: the reference has a position
};

}  // namespace farrier::ros_bridge
