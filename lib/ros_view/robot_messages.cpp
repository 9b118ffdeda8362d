#include "ros_view/robot_messages.hpp"

#include <utility>

#include "ros_messages/cdr.hpp"
#include "ros_messages/names.hpp"
#include "ros_messages/type_description.hpp"
#include "ros_view/topics.hpp"

namespace farrier::ros_view {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kSlow = 20ms;  // dynamic_joint_states and tf
constexpr Nanoseconds kSecond = 1s;

/// Stamps of ticks are not exactly a period apart, so a rate as high as theirs takes every tick.
Nanoseconds period_of(double rate_Hz, const robot::Robot& robot) {
  constexpr double kAlmost = 0.99;
  const double period_s = rate_Hz * robot.period_s > kAlmost ? 0.0 : 1.0 / rate_Hz;
  return std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(period_s));
}

/// For recorder::Due, whose clock only has to go on.
SteadyTime clock_of(std::uint64_t time_ns) { return SteadyTime(Nanoseconds(static_cast<std::int64_t>(time_ns))); }

Time stamp_of(std::uint64_t time_ns) { return time_of(static_cast<std::int64_t>(time_ns)); }

}  // namespace

std::vector<bus::TopicId> frame_topics() {
  using enum bus::TopicId;
  return {kJointSummary, kSystemMode, kSystemHello, kSystemHealth, kSystemEvent};
}

template <ros_messages::Message M>
std::size_t RobotMessages::add_topic(const std::string& name, bool kept, int depth) {
  const ros_messages::TypeDescription type = ros_messages::describe<M>();
  topics_.push_back({.name = ros_messages::full_name(options_.ros_namespace, name),
                     .type = type.name,
                     .type_hash = ros_messages::type_hash(type),
                     .definition = ros_messages::message_text(type),
                     .kept = kept,
                     .depth = depth});
  return topics_.size() - 1;
}

RobotMessages::RobotMessages(const robot::Robot& robot, const Options& options)
    : robot_(robot),
      options_(options),
      joint_states_(add_topic<sensor_msgs::JointState>(kJointStates)),
      dynamic_(add_topic<control_msgs::DynamicJointState>(kDynamicJointStates)),
      diagnostics_topic_(add_topic<diagnostic_msgs::DiagnosticArray>(kDiagnostics)),
      log_(add_topic<rcl_interfaces::Log>(kLog, true, 1000)),
      due_fast_(period_of(options.rate_Hz, robot)),
      due_dynamic_(kSlow),
      due_transforms_(kSlow),
      due_diagnostics_(kSecond),
      joints_(robot.joints.size()) {
  if (!options_.description.empty()) {
    description_ = add_topic<ros_messages::std_msgs::String>(kRobotDescription, true, 1);
  }
  if (robot.body) {
    imu_topic_ = add_topic<sensor_msgs::Imu>(kImu);
    odometry_ = add_topic<nav_msgs::Odometry>(kOdometry);
    transforms_ = add_topic<tf2_msgs::TFMessage>(kTransforms, false, 100);
    for (const body::LegModel& leg : robot.body->legs) {
      wrenches_.push_back(add_topic<geometry_msgs::WrenchStamped>(foot_wrench_topic(leg.name)));
    }
  }
}

void RobotMessages::take(const signals::JointSensors& sensors, std::uint64_t stamp_ns) {
  if (sensors.joint >= joints_.size()) {
    return;
  }
  joints_[sensors.joint].sensors = sensors;
  joints_wait_ = true;
  if (sensors.tick >= joints_tick_) {
    joints_tick_ = sensors.tick;
    joints_stamp_ns_ = stamp_ns;
  }
}

void RobotMessages::take(const signals::JointSummary& summary) {
  if (summary.joint < joints_.size()) {
    joints_[summary.joint].summary = summary;
  }
}

void RobotMessages::take(const signals::BodyImu& imu, std::uint64_t stamp_ns) {
  imu_ = {.sample = imu, .stamp_ns = stamp_ns, .waits = true};
}

void RobotMessages::take(const signals::BodyState& state, std::uint64_t stamp_ns) {
  const std::uint64_t sampled_ns = state.tick == joints_tick_ ? joints_stamp_ns_ : stamp_ns;
  state_ = {.sample = state, .stamp_ns = sampled_ns, .waits = true};
}

void RobotMessages::take(const monitor::Frame& frame, std::uint64_t now_ns) {
  frame_ = frame;
  framed_ = true;
  for (const monitor::EventFrame& event : frame.events) {
    events_.push_back({event, now_ns});
  }
}

template <ros_messages::Message M>
void RobotMessages::hand_on(std::size_t topic, std::uint64_t time_ns, const M& message, const TakeMessage& take) {
  ros_messages::to_cdr(message, bytes_);
  take(topic, time_ns, bytes_);
}

void RobotMessages::publish_joints(std::uint64_t now_ns, const TakeMessage& take) {
  if (!std::exchange(joints_wait_, false)) {
    return;
  }
  const Time stamp = stamp_of(joints_stamp_ns_);
  hand_on(joint_states_, joints_stamp_ns_, joint_state(robot_, joints_, stamp), take);
  if (due_dynamic_.now(clock_of(now_ns))) {
    hand_on(dynamic_, joints_stamp_ns_, dynamic_joint_state(robot_, joints_, stamp), take);
  }
}

void RobotMessages::publish_body(const TakeMessage& take) {
  if (std::exchange(imu_.waits, false)) {
    if (const auto message = imu(imu_.sample, stamp_of(imu_.stamp_ns))) {
      hand_on(imu_topic_, imu_.stamp_ns, *message, take);
    }
  }
  if (!std::exchange(state_.waits, false)) {
    return;
  }
  const Time stamp = stamp_of(state_.stamp_ns);
  if (const auto message = odometry(state_.sample, stamp)) {
    hand_on(odometry_, state_.stamp_ns, *message, take);
    if (due_transforms_.now(clock_of(state_.stamp_ns))) {
      hand_on(transforms_, state_.stamp_ns, transform(*message), take);
    }
  }
  for (std::size_t leg = 0; leg < wrenches_.size(); ++leg) {
    if (const auto message = foot_wrench(robot_, leg, state_.sample, joints_, stamp)) {
      hand_on(wrenches_[leg], state_.stamp_ns, *message, take);
    }
  }
}

void RobotMessages::publish_health(std::uint64_t now_ns, const TakeMessage& take) {
  for (const Event& waiting : std::exchange(events_, {})) {
    hand_on(log_, waiting.time_ns, log_line(waiting.event, options_.node, stamp_of(waiting.time_ns)), take);
  }
  if (framed_ && due_diagnostics_.now(clock_of(now_ns))) {
    hand_on(diagnostics_topic_, now_ns, diagnostics(robot_, frame_, stamp_of(now_ns)), take);
  }
}

void RobotMessages::publish(std::uint64_t now_ns, const TakeMessage& take) {
  publish_health(now_ns, take);
  if (due_fast_.now(clock_of(now_ns))) {
    publish_joints(now_ns, take);
    if (robot_.body) {
      publish_body(take);
    }
  }
}

std::vector<std::uint8_t> RobotMessages::description_cdr() const {
  std::vector<std::uint8_t> bytes;
  if (!options_.description.empty()) {
    ros_messages::to_cdr(ros_messages::std_msgs::String{.data = options_.description}, bytes);
  }
  return bytes;
}

}  // namespace farrier::ros_view
