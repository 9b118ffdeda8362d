#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bus/bus.hpp"
#include "bus_ros/ros_node.hpp"
#include "participant/options.hpp"
#include "robot/robot.hpp"

namespace farrier::ros_bridge {

/// The commands that nodes of ROS may give.
struct CommandOptions {
  Nanoseconds timeout = std::chrono::milliseconds(300);  ///< age of the newest message beyond which there is none
  bool arm = false;                                      ///< they may arm it
  /// They command joints, in the part of locomotion of this run; none: they command velocities.
  std::optional<participant::ProcessOptions> joints = std::nullopt;
};

struct BridgeOptions {
  bus_ros::RosNode::Options node;
  double rate_Hz = 100.0;                  ///< of joint_states, imu and odom; 1 to 1000
  bool transforms = false;                 ///< tf from odom to base_link
  bool simulated_time = false;             ///< stamps count from tick 0, and /clock says so
  std::optional<CommandOptions> commands;  ///< none: nothing is taken from ROS
  std::string description;                 ///< URDF; empty: none is published
};

/// Hands what a robot's processes publish on to ROS 2, and, if it may, commands of ROS on to the robot. It reads topics by
/// polled readers that no writer waits for. Joints of a robot that walks nowhere have joint_states all the same.
class RosBridge {
 public:
  /// `bus` and `robot` must outlive it.
  static Result<RosBridge> create(bus::Bus& bus, const robot::Robot& robot, const BridgeOptions& options);
  RosBridge(RosBridge&&) noexcept;
  RosBridge& operator=(RosBridge&&) noexcept;
  ~RosBridge();

  /// Does what is due now. Returns when the next is due.
  SteadyTime step(SteadyTime now);

  /// A line about topics and samples so far.
  std::string summary() const;

 private:
  struct Parts;
  explicit RosBridge(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace farrier::ros_bridge
