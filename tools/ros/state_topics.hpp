#pragma once

#include <optional>
#include <vector>

#include "bus/bus.hpp"
#include "bus_ros/ros_node.hpp"
#include "robot/robot.hpp"
#include "tools/ros/ros_names.hpp"
#include "tools/ros/sample_stamps.hpp"

namespace farrier::ros_bridge {

/// Topics of the robot's state: joint_states, dynamic_joint_states, and of a robot on a ground imu, odom, a wrench by foot and /tf; /clock.
/// The newest samples, by polled readers that no writer waits for. Joints are read from joint/measurement, which joint_node
/// sends after the valve commands: another reader of joint/sensors would be on the way from sensor to valve.
class StateTopics {
 public:
  struct Options {
    bool transforms = false;  ///< /tf
    bool clock = false;       ///< /clock
  };
  /// `robot` must outlive it.
  static Result<StateTopics> create(bus::Bus& bus, const robot::Robot& robot, bus_ros::RosNode& node,
                                    const SampleStamps& stamps, const Options& options);

  /// Publishes each topic whose samples have come.
  void publish(SteadyTime now);

  /// Gives the newest summary of a joint, for dynamic_joint_states.
  void take(std::size_t joint, const signals::JointSummary& summary) { joints_[joint].summary = summary; }

  /// A new run counts its ticks from 0.
  void begin_run() noexcept { tick_ = kNoTick; }

  Tick tick() const noexcept { return tick_; }
  /// That of the body; lying while none is heard.
  MotionMode motion() const noexcept { return state_ ? state_->sample().mode : MotionMode::kLie; }
  std::uint64_t sent() const noexcept { return sent_; }
  std::uint64_t dropped() const noexcept { return joint_states_.raw().dropped(); }

 private:
  template <class Message>
  using Writer = bus_ros::RosWriter<Message>;

  StateTopics(const robot::Robot& robot, const SampleStamps& stamps, Writer<sensor_msgs::JointState> joint_states,
              Writer<control_msgs::DynamicJointState> dynamic_joint_states,
              bus::Subscription<signals::JointMeasurement> measurements);
  void hear_joints();
  void publish_joints(SteadyTime now);
  void publish_body(SteadyTime now);

  const robot::Robot& robot_;
  SampleStamps stamps_;
  Writer<sensor_msgs::JointState> joint_states_;
  Writer<control_msgs::DynamicJointState> dynamic_joint_states_;
  std::optional<Writer<sensor_msgs::Imu>> imu_out_;
  std::optional<Writer<nav_msgs::Odometry>> odometry_;
  std::vector<Writer<geometry_msgs::WrenchStamped>> wrenches_;  ///< by leg
  std::optional<Writer<tf2_msgs::TFMessage>> transforms_;
  std::optional<Writer<rosgraph_msgs::Clock>> clock_;
  bus::Subscription<signals::JointMeasurement> measurements_;
  std::optional<Newest<signals::BodyImu>> imu_;
  std::optional<Newest<signals::BodyState>> state_;
  std::vector<ros_view::JointSamples> joints_;
  Tick tick_ = kNoTick;
  std::int64_t sample_time_ns_ = 0;  ///< of the tick
  Due due_dynamic_, due_transforms_;
  std::uint64_t sent_ = 0;  ///< of joint_states
};

}  // namespace farrier::ros_bridge
