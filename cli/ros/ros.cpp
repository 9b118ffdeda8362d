// farrier ros: a running robot as a node of ROS 2, without ROS.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/record/guest.hpp"
#include "cli/ros/ros_network.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "ros_messages/names.hpp"
#include "tools/ros/ros_bridge.hpp"
#include "urdf/urdf_reader.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::cli {
namespace {

constexpr double kVelocityTimeout_s = 0.3;
constexpr double kJointTimeout_s = 0.1;
constexpr int kMostParticipants = 256;

struct RosOptions {
  ros_bridge::BridgeOptions bridge;
  RosNetworkOptions network;
  std::string graph = "auto";
  std::string urdf;
  bool commands = false;
  bool joint_commands = false;
  bool allow_arm = false;
  std::optional<double> command_timeout_s;
  int participants = 0;
  GuestOptions guest;
};

/// The URDF to publish: that of the user, or one of the robot file; empty for a robot without rigid bodies.
Result<std::string> description(const RosOptions& o, const robot::Robot& robot) {
  if (o.urdf.empty()) {
    return robot.body ? urdf::urdf_text(robot) : Result<std::string>(std::string());
  }
  auto text = urdf::urdf_file_text(o.urdf);
  if (!text) {
    return Error{config::to_string(text.error())};
  }
  if (const auto read = urdf::read_urdf_text(text.value(), o.urdf); !read) {
    return Error{config::to_string(read.error())};
  }
  return std::move(text).value();
}

/// The commands that nodes of ROS may give.
ros_bridge::CommandOptions commands_of(const RosOptions& o) {
  ros_bridge::CommandOptions commands;
  const double timeout_s = o.command_timeout_s.value_or(o.joint_commands ? kJointTimeout_s : kVelocityTimeout_s);
  commands.timeout = std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(timeout_s));
  commands.arm = o.allow_arm;
  if (o.joint_commands) {
    participant::ProcessOptions& process = commands.joints.emplace();
    process.robot_path = o.guest.robot_path;
    process.vendor = bus::parse_vendor(o.guest.vendor).value();
    process.network = o.guest.network;
    process.security = o.guest.security;
    process.participants = static_cast<std::uint16_t>(o.participants);
  }
  return commands;
}

const char* taken_text(const RosOptions& o) {
  return !o.commands ? "refused" : o.joint_commands ? "of joints, taken from any node" : "taken from any node";
}

int run_bridge(const RosOptions& o, const robot::Robot& robot, const ros_bridge::BridgeOptions& bridge) {
  GuestOptions guest = o.guest;
  guest.network.unhurried = !o.joint_commands;
  auto bus = join_as_guest(guest, o.commands ? bus::Role::kOperator : bus::Role::kMonitor);
  if (!bus) {
    return fail("ros", bus.error().message, bus.error().status);
  }
  auto made = ros_bridge::RosBridge::create(*bus.value(), robot, bridge);
  if (!made) {
    return fail("ros", made.error().message);
  }
  const bus_ros::RosNode::Options& node = bridge.node;
  std::fprintf(stderr, "farrier ros: node %s%s%s in ROS domain %d, discovery %s; commands are %s\n",
               node.ros_namespace.c_str(), node.ros_namespace == "/" ? "" : "/", node.name.c_str(), node.network.domain,
               name_of(bus_ros::kDiscoveries, node.network.discovery), taken_text(o));
  while (!participant::stop_requested()) {
    nap(*bus.value(), made.value().step(participant::steady_now()));
  }
  std::fprintf(stderr, "farrier ros: %s\n", made.value().summary().c_str());
  return participant::stop_status();
}

int run_ros(RosOptions o) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  ros_bridge::BridgeOptions& bridge = o.bridge;
  auto network = ros_network(o.network);
  if (!network) {
    return refuse("ros", network.error().message);
  }
  bridge.node.network = std::move(network).value();
  bridge.node.graph = parse_choice("graph", bus_ros::kGraphs, o.graph).value();
  if (bridge.node.ros_namespace.empty()) {
    bridge.node.ros_namespace = "/" + robot.value().name;
  }
  if (o.commands && !o.joint_commands && !robot.value().can_walk()) {
    return refuse("ros", "--commands: " + robot.value().cannot_walk_error() + ", or add --joint-commands");
  }
  if (o.commands) {
    bridge.commands = commands_of(o);
  }
  auto urdf = description(o, robot.value());
  if (!urdf) {
    return refuse("ros", urdf.error().message);
  }
  bridge.description = std::move(urdf).value();
  return run_bridge(o, robot.value(), bridge);
}

void declare_commands(CLI::App& app, RosOptions& o) {
  CLI::Option* const commands =
      app.add_flag("--commands", o.commands, "take cmd_vel and stop of any node in the ROS domain");
  app.add_flag("--joint-commands", o.joint_commands,
               "with --commands: take joint_commands and impedance_commands in place of cmd_vel, and the part of "
               "locomotion in a run with --no-locomotion")
      ->needs(commands);
  app.add_flag("--allow-arm", o.allow_arm, "with --commands: nodes may also arm the robot, by the topic arm")
      ->needs(commands);
  app.add_option("--command-timeout", o.command_timeout_s, "age of the newest command from which on there is none")
      ->check(between(0.02, 5.0))
      ->type_name("<s>")
      ->default_str("0.3; 0.1 with --joint-commands");
  app.add_option("--participants", o.participants,
                 "with --joint-commands: processes of the run, where no farrier trot started it")
      ->check(CLI::Range(2, kMostParticipants))
      ->type_name("<n>")
      ->default_str("those that farrier trot started");
}

}  // namespace

std::function<int()> declare_ros(CLI::App& app) {
  auto o = std::make_shared<RosOptions>();
  ros_bridge::BridgeOptions& bridge = o->bridge;
  bridge.node.ros_namespace.clear();
  declare_ros_network(app, o->network);
  app.add_option("--ros-namespace", bridge.node.ros_namespace, "namespace of the topics")
      ->check(ros_messages::namespace_error)
      ->type_name("<name>")
      ->default_str("/ and the robot's name");
  add_name(app, "--graph", o->graph, bus_ros::kGraphs,
           "form of the message that names this node, as other nodes know it; nodes of Humble crash on that of jazzy")
      ->capture_default_str();
  app.add_option("--rate", bridge.rate_Hz, "joint_states, imu and odom a second")
      ->check(between(1.0, 1000.0))
      ->type_name("<Hz>")
      ->capture_default_str();
  app.add_option("--urdf", o->urdf, "URDF to publish as robot_description")
      ->check(CLI::ExistingFile)
      ->type_name("<file>")
      ->default_str("as farrier robot urdf writes it");
  app.add_flag("--tf", bridge.transforms, "publish /tf from odom to base_link");
  app.add_flag("--sim-time", bridge.simulated_time, "stamps count from tick 0, and /clock says so; for lock-step");
  declare_commands(app, *o);
  declare_guest(app, o->guest);
  return [o] { return run_ros(*o); };
}

}  // namespace farrier::cli
