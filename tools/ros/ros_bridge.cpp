#include "tools/ros/ros_bridge.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include "monitor/robot_view.hpp"
#include "participant/clock.hpp"
#include "participant/participant.hpp"
#include "recorder/polling.hpp"
#include "recorder/recorder.hpp"
#include "ros_view/conversions.hpp"
#include "tools/ros/velocity_commands.hpp"

namespace farrier::ros_bridge {

namespace rosgraph_msgs = ros_messages::rosgraph_msgs;
namespace std_msgs = ros_messages::std_msgs;

using namespace ros_view;
using recorder::Due;
using recorder::Newest;
using recorder::polled_endpoint;

using bus_ros::RosQos;
using bus_ros::RosReader;
using bus_ros::RosWriter;
using namespace std::chrono_literals;

namespace {

constexpr RosQos kStream{.reliable = true, .transient_local = false, .depth = 10};
constexpr RosQos kLatched{.reliable = true, .transient_local = true, .depth = 1};
constexpr RosQos kLog{.reliable = true, .transient_local = true, .depth = 1000};
constexpr RosQos kTransforms{.reliable = true, .transient_local = false, .depth = 100};
constexpr RosQos kClock{.reliable = true, .transient_local = false, .depth = 1};
// Hears reliable and best-effort writers alike.
constexpr RosQos kCommands{.reliable = false, .transient_local = false, .depth = 1};

constexpr Nanoseconds kView = 100ms;
constexpr Nanoseconds kSlow = 20ms;    // dynamic_joint_states and tf
constexpr Nanoseconds kRepeat = 50ms;  // of a command; locomotion takes half a second of silence for a lost operator
constexpr Nanoseconds kSecond = 1s;

}  // namespace

/// Ends of the ROS side that are always open.
struct Writers {
  RosWriter<sensor_msgs::JointState> joints;
  RosWriter<control_msgs::DynamicJointState> dynamic_joints;
  RosWriter<diagnostic_msgs::DiagnosticArray> diagnostics;
  RosWriter<rcl_interfaces::Log> log;
  std::optional<RosWriter<std_msgs::String>> description{};
  std::optional<RosWriter<sensor_msgs::Imu>> imu{};
  std::optional<RosWriter<nav_msgs::Odometry>> odometry{};
  std::optional<RosWriter<tf2_msgs::TFMessage>> transforms{};
  std::optional<RosWriter<rosgraph_msgs::Clock>> clock{};
};

struct Readers {
  std::optional<RosReader<geometry_msgs::Twist>> velocity{};
  std::optional<RosReader<geometry_msgs::TwistStamped>> stamped_velocity{};
};

struct RosBridge::Parts {
  bus::Bus& bus;
  const robot::Robot& robot;
  BridgeOptions options;
  bus_ros::RosNode node;
  Writers writers;
  Readers readers;
  recorder::Recorder slow_topics;
  monitor::RobotView view;
  bus::Subscription<signals::JointSensors> sensors;
  std::optional<Newest<signals::BodyImu>> imu;
  std::optional<Newest<signals::BodyState>> state;
  std::optional<bus::Publisher<signals::BodyCommand>> commands;
  VelocityCommands velocities;

  std::vector<JointSamples> joints{};
  Tick tick = kNoTick;
  std::int64_t sample_time_ns = 0;
  std::uint64_t session = 0;
  std::uint32_t count = 0;
  monitor::Frame frame{};
  std::map<std::string, SteadyTime> told{};
  Due due_state{Nanoseconds(1s)}, due_transforms{kSlow}, due_dynamic{kSlow}, due_view{kView}, due_diagnostics{kSecond},
      due_graph{500ms}, due_command{kRepeat};
  std::uint64_t states_sent = 0;

  /// Time of a sample in ROS: the date when it was taken, or the simulation's. Clocks of other computers count from other
  /// begins, so an age that cannot be is left out.
  Time stamp_of(Tick of_tick, std::int64_t sampled_ns, SteadyTime now) const {
    if (options.simulated_time) {
      return time_of(static_cast<std::int64_t>(static_cast<double>(of_tick) * robot.period_s * 1e9));
    }
    const auto date_ns = static_cast<std::int64_t>(participant::date_now_ns());
    const std::int64_t age_ns = now.time_since_epoch().count() - sampled_ns;
    const bool possible = sampled_ns > 0 && age_ns >= 0 && age_ns < Nanoseconds(1s).count();
    return time_of(possible ? date_ns - age_ns : date_ns);
  }

  /// Says something to users of ROS and of this command, at most once in five seconds.
  void tell(signals::Severity severity, const std::string& text, SteadyTime now) {
    constexpr Nanoseconds kOften = 5s;
    SteadyTime& last = told[text];
    if (text.empty() || (last != SteadyTime{} && now - last < kOften)) {
      return;
    }
    last = now;
    std::fprintf(stderr, "farrier ros: %s\n", text.c_str());
    monitor::EventFrame event;
    event.severity = severity;
    event.who = "bridge";
    event.text = text;
    writers.log.write(log_line(event, options.node.name, stamp_of(tick, 0, now)));
  }

  void hear_joints() {
    sensors.drain([this](const signals::JointSensors& sample) {
      if (signals::is_probe(sample) || sample.joint >= joints.size()) {
        return;
      }
      joints[sample.joint].sensors = sample;
      if (sample.tick >= tick) {
        tick = sample.tick;
        sample_time_ns = sample.sample_time_ns;
      }
    });
  }

  void publish_states(SteadyTime now) {
    const Tick before = tick;
    hear_joints();
    if (tick != before) {
      const Time stamp = stamp_of(tick, sample_time_ns, now);
      if (writers.clock) {
        writers.clock->write({.clock = stamp});
      }
      states_sent += writers.joints.write(joint_state(robot, joints, stamp)) ? 1 : 0;
      if (due_dynamic.now(now)) {
        writers.dynamic_joints.write(dynamic_joint_state(robot, joints, stamp));
      }
    }
    if (imu && imu->drain()) {
      const signals::BodyImu& sample = imu->sample();
      if (const auto message = ros_bridge::imu(sample, stamp_of(sample.tick, sample.sample_time_ns, now))) {
        writers.imu->write(*message);
      }
    }
    if (state && state->drain()) {
      const signals::BodyState& sample = state->sample();
      // A state is estimated from the sensors of its tick.
      const std::int64_t sampled_ns = sample.tick == tick ? sample_time_ns : 0;
      if (const auto message = odometry(sample, stamp_of(sample.tick, sampled_ns, now))) {
        writers.odometry->write(*message);
        if (writers.transforms && due_transforms.now(now)) {
          writers.transforms->write(transform(*message));
        }
      }
    }
  }

  /// Samples that come seldom, as a frame; its events go to the log.
  void look(SteadyTime now) {
    const auto now_ns = static_cast<std::uint64_t>(now.time_since_epoch().count());
    slow_topics.drain([&](recording::Sample sample) {
      sample.log_time_ns = now_ns;
      view.take(sample);
    });
    frame = view.frame(now_ns);
    for (const monitor::ParticipantFrame& process : frame.participants) {
      session = process.hello.session != 0 ? process.hello.session : session;
    }
    for (const monitor::EventFrame& event : frame.events) {
      writers.log.write(log_line(event, options.node.name, stamp_of(event.tick, 0, now)));
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      joints[i].summary = frame.joints[i].newest;
    }
  }

  void take_velocities(SteadyTime now) {
    bool came = false;
    const auto take = [&](const geometry_msgs::Twist& twist, std::uint64_t sender) {
      const std::string refusal = velocities.take(twist, sender, now);
      tell(signals::Severity::kWarning, refusal.empty() ? "" : "refused: " + refusal, now);
      came = came || refusal.empty();
    };
    readers.velocity->take(take);
    readers.stamped_velocity->take(
        [&](const geometry_msgs::TwistStamped& stamped, std::uint64_t sender) { take(stamped.twist, sender); });
    if (!came && !due_command.now(now)) {
      return;
    }
    const MotionMode mode = state ? state->sample().mode : MotionMode::kLie;
    if (auto command = velocities.command(now, mode); command && session != 0) {
      command->session = session;
      command->tick = std::max<Tick>(tick, 0);
      command->count = ++count;
      commands->publish(*command);
    }
  }
};

RosBridge::RosBridge(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RosBridge::RosBridge(RosBridge&&) noexcept = default;
RosBridge& RosBridge::operator=(RosBridge&&) noexcept = default;
RosBridge::~RosBridge() = default;

Result<RosBridge> RosBridge::create(bus::Bus& bus, const robot::Robot& robot, const BridgeOptions& options) {
  bus_ros::RosNode node = FARRIER_TRY(bus_ros::RosNode::create(options.node));
  Writers writers{FARRIER_TRY(node.writer<sensor_msgs::JointState>("joint_states", kStream)),
                  FARRIER_TRY(node.writer<control_msgs::DynamicJointState>("dynamic_joint_states", kStream)),
                  FARRIER_TRY(node.writer<diagnostic_msgs::DiagnosticArray>("/diagnostics", kStream)),
                  FARRIER_TRY(node.writer<rcl_interfaces::Log>("/rosout", kLog))};
  if (!options.description.empty()) {
    writers.description = FARRIER_TRY(node.writer<std_msgs::String>("robot_description", kLatched));
    writers.description->write({.data = options.description});
  }
  std::optional<Newest<signals::BodyImu>> imu;
  std::optional<Newest<signals::BodyState>> state;
  if (robot.body) {
    writers.imu = FARRIER_TRY(node.writer<sensor_msgs::Imu>("imu", kStream));
    writers.odometry = FARRIER_TRY(node.writer<nav_msgs::Odometry>("odom", kStream));
    imu = FARRIER_TRY(Newest<signals::BodyImu>::create(bus, robot));
    state = FARRIER_TRY(Newest<signals::BodyState>::create(bus, robot));
  }
  if (options.transforms) {
    writers.transforms = FARRIER_TRY(node.writer<tf2_msgs::TFMessage>("/tf", kTransforms));
  }
  if (options.simulated_time) {
    writers.clock = FARRIER_TRY(node.writer<rosgraph_msgs::Clock>("/clock", kClock));
  }
  Readers readers;
  std::optional<bus::Publisher<signals::BodyCommand>> commands;
  if (options.commands) {
    readers.velocity = FARRIER_TRY(node.reader<geometry_msgs::Twist>("cmd_vel", kCommands));
    readers.stamped_velocity = FARRIER_TRY(node.reader<geometry_msgs::TwistStamped>("cmd_vel_stamped", kCommands));
    const participant::Identity identity{.name = "operator", .robot = robot.name, .clock = bus::ClockKind::kRealtime};
    commands = FARRIER_TRY(bus::Publisher<signals::BodyCommand>::create(
        bus, participant::endpoint_of(identity, bus::TopicId::kBodyCommand)));
  }
  using enum bus::TopicId;
  auto slow_topics = FARRIER_TRY(
      recorder::Recorder::create(bus, robot, {kJointSummary, kSystemMode, kSystemHello, kSystemHealth, kSystemEvent}));
  auto sensors =
      FARRIER_TRY(bus::Subscription<signals::JointSensors>::create(bus, polled_endpoint(robot, kJointSensors)));
  auto parts = std::unique_ptr<Parts>(new Parts{.bus = bus,
                                                .robot = robot,
                                                .options = options,
                                                .node = std::move(node),
                                                .writers = std::move(writers),
                                                .readers = std::move(readers),
                                                .slow_topics = std::move(slow_topics),
                                                .view = monitor::RobotView(robot),
                                                .sensors = std::move(sensors),
                                                .imu = std::move(imu),
                                                .state = std::move(state),
                                                .commands = std::move(commands),
                                                .velocities = VelocityCommands(options.command_timeout)});
  parts->joints.resize(robot.joints.size());
  parts->due_state = Due(std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(1.0 / options.rate_Hz)));
  return RosBridge(std::move(parts));
}

SteadyTime RosBridge::step(SteadyTime now) {
  Parts& p = *parts_;
  if (p.due_state.now(now)) {
    p.publish_states(now);
    if (p.commands) {
      p.take_velocities(now);
    }
  }
  if (p.due_view.now(now)) {
    p.look(now);
  }
  if (p.due_diagnostics.now(now)) {
    p.writers.diagnostics.write(diagnostics(p.robot, p.frame, p.stamp_of(p.tick, 0, now)));
  }
  if (p.due_graph.now(now)) {
    p.tell(signals::Severity::kInfo, p.node.look(), now);
  }
  return p.due_state.next();
}

std::string RosBridge::summary() const {
  return std::to_string(parts_->states_sent) + " samples of " + parts_->node.full_name("joint_states") + ", " +
         std::to_string(parts_->writers.joints.raw().dropped()) + " dropped for slow readers";
}

}  // namespace farrier::ros_bridge
