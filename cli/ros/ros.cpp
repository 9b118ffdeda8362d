// farrier ros: a running robot as a node of ROS 2, without ROS.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/record/guest.hpp"
#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "tools/ros/ros_bridge.hpp"
#include "urdf/urdf_reader.hpp"
#include "urdf/urdf_text.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

struct RosOptions {
  ros_bridge::BridgeOptions bridge;
  std::string discovery;
  std::string graph = "auto";
  std::string urdf;
  double command_timeout_s = 0.3;
  GuestOptions guest;
};

/// A variable of the environment, or `otherwise` where it is not set or empty.
std::string variable(const char* name, const std::string& otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr || *value == '\0' ? otherwise : value;
}

/// The discovery range that the environment of ROS names: that of Iron and later, else that of Humble.
std::string usual_discovery() {
  const std::string range = variable("ROS_AUTOMATIC_DISCOVERY_RANGE", "");
  return range == "SUBNET" ? "subnet" : "localhost";
}

/// Computers of ROS_STATIC_PEERS, which semicolons separate.
std::vector<std::string> static_peers() {
  std::vector<std::string> peers;
  std::istringstream list(variable("ROS_STATIC_PEERS", ""));
  for (std::string peer; std::getline(list, peer, ';');) {
    if (!peer.empty()) {
      peers.push_back(peer);
    }
  }
  return peers;
}

int usual_domain() { return std::atoi(variable("ROS_DOMAIN_ID", "0").c_str()); }

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

int run_ros(RosOptions o) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  ros_bridge::BridgeOptions& bridge = o.bridge;
  bridge.node.network.discovery = parse_choice("discovery", bus_ros::kDiscoveries, o.discovery).value();
  bridge.node.graph = parse_choice("graph", bus_ros::kGraphs, o.graph).value();
  bridge.command_timeout = std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(o.command_timeout_s));
  if (bridge.node.ros_namespace.empty()) {
    bridge.node.ros_namespace = "/" + robot.value().name;
  }
  if (bridge.commands && !robot.value().can_walk()) {
    return refuse("ros", "--commands: " + robot.value().cannot_walk_error());
  }
  auto urdf = description(o, robot.value());
  if (!urdf) {
    return refuse("ros", urdf.error().message);
  }
  bridge.description = std::move(urdf).value();
  auto bus = join_as_guest(o.guest, bridge.commands ? bus::Role::kOperator : bus::Role::kMonitor);
  if (!bus) {
    return fail("ros", bus.error().message, bus.error().status);
  }
  auto made = ros_bridge::RosBridge::create(*bus.value(), robot.value(), bridge);
  if (!made) {
    return fail("ros", made.error().message);
  }
  std::fprintf(stderr, "farrier ros: node %s%s%s in ROS domain %d, discovery %s; commands are %s\n",
               bridge.node.ros_namespace.c_str(), bridge.node.ros_namespace == "/" ? "" : "/", bridge.node.name.c_str(),
               bridge.node.network.domain, o.discovery.c_str(), bridge.commands ? "taken from any node" : "refused");
  while (!participant::stop_requested()) {
    nap(*bus.value(), made.value().step(participant::steady_now()));
  }
  std::fprintf(stderr, "farrier ros: %s\n", made.value().summary().c_str());
  return participant::stop_status();
}

std::string namespace_error(const std::string& text) {
  const bool good = text == "/" || (text.size() > 1 && text.front() == '/' && text.back() != '/' &&
                                    text.find("//") == std::string::npos &&
                                    text.find_first_not_of("/_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                           "0123456789") == std::string::npos);
  return good ? "" : "give / or a name like /hyq, of letters, digits and _";
}

}  // namespace

std::function<int()> declare_ros(CLI::App& app) {
  auto o = std::make_shared<RosOptions>();
  ros_bridge::BridgeOptions& bridge = o->bridge;
  bridge.node.network.domain = usual_domain();
  bridge.node.network.peers = static_peers();
  bridge.node.ros_namespace.clear();
  o->discovery = usual_discovery();
  app.add_option("--ros-domain", bridge.node.network.domain, "domain of the nodes of ROS 2")
      ->check(CLI::Range(0, 232))
      ->type_name("<n>")
      ->default_str("ROS_DOMAIN_ID, else 0");
  add_name(app, "--ros-discovery", o->discovery, bus_ros::kDiscoveries,
           "where nodes are searched: on this computer, or on its network by multicast")
      ->default_str("localhost, or what ROS_AUTOMATIC_DISCOVERY_RANGE says");
  app.add_option("--ros-address", bridge.node.network.address, "IPv4 address of this computer for ROS 2")
      ->type_name("<ip>")
      ->default_str("Cyclone's choice");
  app.add_option("--ros-peers", bridge.node.network.peers, "further computers to look for nodes on")
      ->delimiter(',')
      ->type_name("<ip>,...")
      ->default_str("ROS_STATIC_PEERS");
  app.add_option("--ros-namespace", bridge.node.ros_namespace, "namespace of the topics")
      ->check(namespace_error)
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
  app.add_flag("--commands", bridge.commands, "take velocities from cmd_vel, of any node in the ROS domain");
  app.add_option("--command-timeout", o->command_timeout_s, "age of the newest cmd_vel from which on there is none")
      ->check(between(0.02, 5.0))
      ->type_name("<s>")
      ->capture_default_str();
  declare_guest(app, o->guest);
  return [o] { return run_ros(*o); };
}

}  // namespace farrier::cli
