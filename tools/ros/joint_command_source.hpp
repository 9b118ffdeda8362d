#pragma once

// Commands of ROS in the part of locomotion.
//
//   joint_commands, impedance_commands (ROS) ──▶ JointReferences ──▶ joint/command for tick k + 1, when clock/tick k comes
//   joint/sensors, lf/joint/summary ─────────────────▲ measured angles, and which joints follow.
//
// It announces no phase, so every joint keeps the gains of stance. While the sender of ROS is silent it says nothing: joints
// damp, and trip, by their own rules.

#include <atomic>
#include <memory>

#include "bus_ros/ros_node.hpp"
#include "locomotion/locomotion.hpp"
#include "tools/ros/joint_references.hpp"
#include "tools/ros/notices.hpp"

namespace farrier::ros_bridge {

/// Readers of the commands. The thread that runs the source uses them alone.
struct JointCommandReaders {
  bus_ros::RosReader<ros_messages::sensor_msgs::JointState> joints;
  bus_ros::RosReader<ros_messages::control_msgs::DynamicJointState> impedances;

  /// Opens joint_commands and impedance_commands.
  static Result<JointCommandReaders> open(bus_ros::RosNode& node);
};

/// State that the source's thread and the bridge share.
struct JointCommandState {
  std::atomic<bool> ends{false};      ///< the source is asked to leave the run
  std::atomic<bool> commands{false};  ///< it sends commands
  NoticeQueue notices;
};

/// The process's part in the run, on the real-time clock. `readers` and `state` must outlive it.
Result<std::unique_ptr<participant::Application>> create_joint_command_source(const robot::Robot& robot,
                                                                              participant::Participant& participant,
                                                                              Nanoseconds timeout,
                                                                              JointCommandReaders& readers,
                                                                              JointCommandState& state);

}  // namespace farrier::ros_bridge
