#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "recorder/polling.hpp"
#include "ros_view/conversions.hpp"

namespace farrier::ros_view {

/// A topic of a robot, for those who hand messages on as bytes: Foxglove's protocol and bags.
struct Topic {
  std::string name;        ///< "/hyq/joint_states"
  std::string type;        ///< "sensor_msgs/msg/JointState"
  std::string type_hash;   ///< ros_messages::type_hash
  std::string definition;  ///< ros_messages::message_text
  bool kept = false;       ///< late joiners get the newest messages: transient local
  int depth = 10;          ///< of its QoS
};

/// Gets a message of topics()[topic], valid for the call: ros_messages::to_cdr. `time_ns` is its stamp, or else the time of
/// publish().
using TakeMessage = std::function<void(std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr)>;

/// Topics of the bus that the frames of RobotMessages need.
std::vector<bus::TopicId> frame_topics();

/// Makes messages of ROS 2 of a robot's samples, at the rates of their topics. Times are ns since 1970, and not 0.
class RobotMessages {
 public:
  struct Options {
    std::string ros_namespace = "/";
    std::string node = "farrier";  ///< in /rosout
    double rate_Hz = 100.0;        ///< of joint states, imu, odom and foot wrenches
    std::string description;       ///< URDF; empty: no such topic
  };

  /// `robot` must outlive it.
  RobotMessages(const robot::Robot& robot, const Options& options);

  const std::vector<Topic>& topics() const noexcept { return topics_; }

  /// Newest samples. `stamp_ns`: when a sample was taken. A state is estimated from the sensors of its tick, and has their
  /// stamp where that tick is the newest.
  void take(const signals::JointSensors& sensors, std::uint64_t stamp_ns);
  void take(const signals::JointSummary& summary);
  void take(const signals::BodyImu& imu, std::uint64_t stamp_ns);
  void take(const signals::BodyState& state, std::uint64_t stamp_ns);

  /// The newest frame of the robot, for diagnostics; its events wait for publish(), with the time `now_ns`.
  void take(const monitor::Frame& frame, std::uint64_t now_ns);

  /// Hands on what has come and is due. Messages of a time before the last call's wait until then.
  void publish(std::uint64_t now_ns, const TakeMessage& take);

  /// The description as a message; no bytes without one.
  std::vector<std::uint8_t> description_cdr() const;
  std::size_t description_topic() const noexcept { return description_; }

 private:
  /// The newest sample, until it is handed on.
  template <class Signal>
  struct Waiting {
    Signal sample{};
    std::uint64_t stamp_ns = 0;
    bool waits = false;
  };
  struct Event {
    monitor::EventFrame event;
    std::uint64_t time_ns;
  };

  template <ros_messages::Message M>
  std::size_t add_topic(const std::string& name, bool kept = false, int depth = 10);
  template <ros_messages::Message M>
  void hand_on(std::size_t topic, std::uint64_t time_ns, const M& message, const TakeMessage& take);
  void publish_joints(std::uint64_t now_ns, const TakeMessage& take);
  void publish_body(const TakeMessage& take);
  void publish_health(std::uint64_t now_ns, const TakeMessage& take);

  const robot::Robot& robot_;
  Options options_;
  std::vector<Topic> topics_;
  std::size_t joint_states_, dynamic_, diagnostics_topic_, log_;
  std::size_t description_ = 0, imu_topic_ = 0, odometry_ = 0, transforms_ = 0;
  std::vector<std::size_t> wrenches_;  // by leg
  recorder::Due due_fast_, due_dynamic_, due_transforms_, due_diagnostics_;

  std::vector<JointSamples> joints_;
  Tick joints_tick_ = kNoTick;
  std::uint64_t joints_stamp_ns_ = 0;
  bool joints_wait_ = false;
  Waiting<signals::BodyImu> imu_;
  Waiting<signals::BodyState> state_;
  monitor::Frame frame_;
  bool framed_ = false;
  std::vector<Event> events_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace farrier::ros_view
