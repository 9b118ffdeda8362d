#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <string>

#include "bus_ros/ros_node.hpp"
#include "core/time.hpp"
#include "signals/signals.hpp"
#include "tools/ros/ros_names.hpp"

namespace farrier::ros_bridge {

/// Lines of /rosout and of standard error for users of ROS and of this command. A text is said at most
/// once in five seconds, and at most kMost texts are.
class Notices {
 public:
  static constexpr std::size_t kMost = 20;

  /// `node`: that the lines are of.
  Notices(bus_ros::RosWriter<rcl_interfaces::Log> log, std::string node)
      : log_(std::move(log)), node_(std::move(node)) {}

  /// Says it now. An empty text is none.
  void tell(signals::Severity severity, const std::string& text, const Time& stamp, SteadyTime now);

  /// Writes an event of the robot.
  void write(const monitor::EventFrame& event, const Time& stamp);

 private:
  bus_ros::RosWriter<rcl_interfaces::Log> log_;
  std::string node_;
  std::map<std::string, SteadyTime> told_;  ///< of the last five seconds
};

/// Notices of another thread, until the one that has Notices says them. Those that find no room are dropped.
class NoticeQueue {
 public:
  struct Notice {
    signals::Severity severity;
    std::string text;
  };
  void put(signals::Severity severity, std::string text);
  std::deque<Notice> take();

 private:
  std::mutex mutex_;
  std::deque<Notice> waiting_;
};

}  // namespace farrier::ros_bridge
