#include "tools/ros/ros_bridge.hpp"

#include "ros_view/topics.hpp"
#include "tools/ros/command_topics.hpp"
#include "tools/ros/notices.hpp"
#include "tools/ros/ros_qos.hpp"
#include "tools/ros/state_topics.hpp"
#include "tools/ros/status_topics.hpp"

namespace farrier::ros_bridge {

using bus_ros::RosWriter;
using namespace std::chrono_literals;

/// The node, then the topics that live in it, each part of which a header of this folder describes.
struct RosBridge::Parts {
  bus_ros::RosNode node;
  SampleStamps stamps;
  Notices notices;
  StateTopics states;
  StatusTopics status;
  std::optional<RosWriter<std_msgs::String>> description{};
  std::optional<CommandTopics> commands{};
  std::uint64_t session = 0;
  Due due_states, due_commands{10ms}, due_status{100ms}, due_diagnostics{1s}, due_graph{500ms};

  CommandTopics::Tell tell(SteadyTime now) {
    return [this, now](signals::Severity severity, const std::string& text) {
      notices.tell(severity, text, stamps.of_now(states.tick()), now);
    };
  }

  void look(SteadyTime now) {
    status.look(now);
    if (status.session() != session) {
      session = status.session();
      states.begin_run();
    }
    for (const monitor::EventFrame& event : status.frame().events) {
      notices.write(event, stamps.of_now(event.tick));
    }
    for (std::size_t i = 0; i < status.frame().joints.size(); ++i) {
      states.take(i, status.frame().joints[i].newest);
    }
    if (commands) {
      commands->look(status.frame(), tell(now));
    }
  }
};

RosBridge::RosBridge(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RosBridge::RosBridge(RosBridge&&) noexcept = default;
RosBridge& RosBridge::operator=(RosBridge&&) noexcept = default;
RosBridge::~RosBridge() = default;

Result<RosBridge> RosBridge::create(bus::Bus& bus, const robot::Robot& robot, const BridgeOptions& options) {
  auto node = FARRIER_TRY(bus_ros::RosNode::create(options.node));
  const SampleStamps stamps(robot.period_s, options.simulated_time);
  auto log = FARRIER_TRY(node.writer<rcl_interfaces::Log>(ros_view::kLog, kLogQos));
  auto states = FARRIER_TRY(StateTopics::create(bus, robot, node, stamps,
                                                {.transforms = options.transforms, .clock = options.simulated_time}));
  auto status = FARRIER_TRY(StatusTopics::create(bus, robot, node));
  const auto period = std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(1.0 / options.rate_Hz));
  std::unique_ptr<Parts> parts(new Parts{.node = std::move(node),
                                         .stamps = stamps,
                                         .notices = Notices(std::move(log), options.node.name),
                                         .states = std::move(states),
                                         .status = std::move(status),
                                         .due_states = Due(period)});
  if (!options.description.empty()) {
    parts->description = FARRIER_TRY(parts->node.writer<std_msgs::String>(ros_view::kRobotDescription, kLatchedQos));
    parts->description->write({.data = options.description});
  }
  if (options.commands) {
    parts->commands = FARRIER_TRY(CommandTopics::create(bus, robot, parts->node, *options.commands));
  }
  return RosBridge(std::move(parts));
}

SteadyTime RosBridge::step(SteadyTime now) {
  Parts& p = *parts_;
  if (p.due_states.now(now)) {
    p.states.publish(now);
  }
  if (p.commands && p.due_commands.now(now)) {
    p.commands->take({p.session, p.states.tick()}, p.states.motion(), now, p.tell(now));
  }
  if (p.due_status.now(now)) {
    p.look(now);
  }
  if (p.due_diagnostics.now(now)) {
    p.status.publish(p.stamps.of_now(p.states.tick()));
  }
  if (p.due_graph.now(now)) {
    p.tell(now)(signals::Severity::kInfo, p.node.look());
  }
  const SteadyTime next = std::min(p.due_states.next(), p.due_status.next());
  return p.commands ? std::min(next, p.due_commands.next()) : next;
}

std::string RosBridge::summary() const {
  return std::to_string(parts_->states.sent()) + " samples of " + parts_->node.full_name(ros_view::kJointStates) +
         ", " + std::to_string(parts_->states.dropped()) + " dropped for slow readers";
}

}  // namespace farrier::ros_bridge
