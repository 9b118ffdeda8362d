#pragma once

#include <functional>
#include <string>

#include "bus/bus.hpp"
#include "bus_ros/ros_node.hpp"
#include "robot/robot.hpp"
#include "tools/ros/ros_names.hpp"
#include "tools/ros/velocity_commands.hpp"

namespace farrier::ros_bridge {

/// The robot's run as an operator addresses it.
struct Run {
  std::uint64_t session = 0;  ///< 0: none is heard
  Tick tick = kNoTick;        ///< newest
};

/// cmd_vel and cmd_vel_stamped, which become body/command.
class VelocityTopics {
 public:
  static Result<VelocityTopics> create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                       Nanoseconds timeout);

  /// Takes what has come, and sends a command when one is due. `refused` gets the reason of each refusal.
  void take(const Run& run, MotionMode motion, SteadyTime now, const std::function<void(const std::string&)>& refused);

 private:
  using Twist = ros_messages::geometry_msgs::Twist;
  using TwistStamped = ros_messages::geometry_msgs::TwistStamped;

  VelocityTopics(bus_ros::RosReader<Twist> velocity, bus_ros::RosReader<TwistStamped> stamped_velocity,
                 bus::Publisher<signals::BodyCommand> commands, Nanoseconds timeout);

  bus_ros::RosReader<Twist> velocity_;
  bus_ros::RosReader<TwistStamped> stamped_velocity_;
  bus::Publisher<signals::BodyCommand> commands_;
  VelocityCommands velocities_;
  Due due_;
  std::uint32_t count_ = 0;
};

}  // namespace farrier::ros_bridge
