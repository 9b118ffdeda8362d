#pragma once

#include <vector>

#include "bus/bus.hpp"
#include "bus_ros/ros_node.hpp"
#include "monitor/robot_view.hpp"
#include "recorder/recorder.hpp"
#include "robot/robot.hpp"
#include "tools/ros/ros_names.hpp"

namespace farrier::ros_bridge {

/// The robot's health: topics that come seldom, as a frame, which /diagnostics is made of.
class StatusTopics {
 public:
  /// `robot` must outlive it.
  static Result<StatusTopics> create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node);

  /// Reads what has come into frame().
  void look(SteadyTime now);

  /// Publishes /diagnostics.
  void publish(const Time& stamp) { diagnostics_.write(ros_view::diagnostics(robot_, frame_, stamp)); }

  const monitor::Frame& frame() const noexcept { return frame_; }
  /// Session of the newest run; 0: none is heard.
  std::uint64_t session() const noexcept { return session_; }

 private:
  StatusTopics(const robot::Robot& robot, recorder::Recorder slow_topics,
               bus_ros::RosWriter<diagnostic_msgs::DiagnosticArray> diagnostics)
      : robot_(robot), slow_topics_(std::move(slow_topics)), view_(robot), diagnostics_(std::move(diagnostics)) {
    frame_.joints.resize(robot.joints.size());
  }

  const robot::Robot& robot_;
  recorder::Recorder slow_topics_;
  monitor::RobotView view_;
  monitor::Frame frame_;
  std::uint64_t session_ = 0;
  bus_ros::RosWriter<diagnostic_msgs::DiagnosticArray> diagnostics_;
};

}  // namespace farrier::ros_bridge
