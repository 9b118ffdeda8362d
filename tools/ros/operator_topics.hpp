#pragma once

#include <functional>
#include <optional>
#include <string>

#include "bus/bus.hpp"
#include "bus_ros/ros_node.hpp"
#include "participant/operator.hpp"
#include "robot/robot.hpp"
#include "tools/ros/ros_names.hpp"
#include "tools/ros/velocity_topics.hpp"

namespace farrier::ros_bridge {

/// Decides which messages of stop and arm ask the supervisor for a mode. Any sender may stop. A `true` of arm counts if
/// none came in the kPulse before it, and no stop: a sender that repeats it cannot undo a stop.
class OperatorPulses {
 public:
  static constexpr Nanoseconds kPulse = std::chrono::seconds(1);

  /// True if the robot is to be stopped.
  bool stop(bool value, SteadyTime now) noexcept {
    stopped_ = value ? now : stopped_;
    return value;
  }
  /// True if it is to be armed.
  bool arm(bool value, SteadyTime now) noexcept {
    const auto long_ago = [&](SteadyTime time) { return time == SteadyTime{} || now - time > kPulse; };
    const bool counts = value && long_ago(armed_) && long_ago(stopped_);
    armed_ = value ? now : armed_;
    return counts;
  }

 private:
  SteadyTime stopped_{}, armed_{};  ///< newest `true`
};

/// stop and arm, which become system/request, as `farrier request` sends it.
class OperatorTopics {
 public:
  using Tell = std::function<void(signals::Severity, const std::string&)>;

  /// `arm`: the node hears arm, too.
  static Result<OperatorTopics> create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node, bool arm);

  /// Takes what has come and asks the supervisor until it answers. `cannot_arm`: why the robot is not armed now; empty if
  /// it may be.
  void take(const Run& run, const std::string& cannot_arm, SteadyTime now, const Tell& tell);

 private:
  using Bool = ros_messages::std_msgs::Bool;

  OperatorTopics(bus_ros::RosReader<Bool> stop, bus_ros::RosReader<Bool> repeated_stop,
                 std::optional<bus_ros::RosReader<Bool>> arm, bus::Publisher<signals::SystemRequest> requests,
                 Newest<signals::SystemMode> modes)
      : stop_(std::move(stop)),
        repeated_stop_(std::move(repeated_stop)),
        arm_(std::move(arm)),
        requests_(std::move(requests)),
        modes_(std::move(modes)) {}
  void ask(signals::Request what, const Run& run, SteadyTime now, const Tell& tell);
  bool stop_is_due(const Run& run, SteadyTime now) const noexcept;
  void follow(SteadyTime now, const Tell& tell);
  void forget() noexcept {
    pending_.reset();
    pending_stop_ = false;
  }

  bus_ros::RosReader<Bool> stop_;           ///< of writers of both kinds
  bus_ros::RosReader<Bool> repeated_stop_;  ///< of reliable ones, with what is lost on the way
  std::optional<bus_ros::RosReader<Bool>> arm_;
  bus::Publisher<signals::SystemRequest> requests_;
  Newest<signals::SystemMode> modes_;
  OperatorPulses pulses_;
  std::optional<participant::ModeRequest> pending_;
  bool pending_stop_ = false;
  SteadyTime asked_{};
};

}  // namespace farrier::ros_bridge
