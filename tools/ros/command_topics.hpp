#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "tools/ros/joint_command_run.hpp"
#include "tools/ros/operator_topics.hpp"
#include "tools/ros/ros_bridge.hpp"
#include "tools/ros/velocity_topics.hpp"

namespace farrier::ros_bridge {

/// Everything that nodes of ROS may do to the robot: stop and arm, and velocities or joint commands.
class CommandTopics {
 public:
  using Tell = OperatorTopics::Tell;

  /// `robot` must outlive it.
  static Result<CommandTopics> create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                      const CommandOptions& options);

  /// Takes what has come. Call it every 10 ms.
  void take(const Run& run, MotionMode motion, SteadyTime now, const Tell& tell);

  /// Looks which run there is to take part in. Call it a few times a second.
  void look(const monitor::Frame& frame, const Tell& tell);

 private:
  CommandTopics(OperatorTopics operators, int participants)
      : operators_(std::move(operators)), participants_(participants) {}
  std::string cannot_arm() const;

  OperatorTopics operators_;
  int participants_;  ///< of the run, where no launcher says it; 0: it does
  std::optional<VelocityTopics> velocities_;
  std::unique_ptr<JointCommandRun> joints_;
};

}  // namespace farrier::ros_bridge
