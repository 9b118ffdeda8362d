#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

#include "bus_ros/ros_network.hpp"
#include "core/result.hpp"

namespace farrier::cli {

/// The DDS domain of ROS 2 as the command line says; what it leaves out is as the environment of ROS says.
struct RosNetworkOptions {
  std::optional<int> domain;
  std::string discovery;  ///< empty: not given
  std::string address;
  std::vector<std::string> peers;
};

/// --ros-domain, --ros-discovery, --ros-address and --ros-peers.
void declare_ros_network(CLI::App& app, RosNetworkOptions& options);

/// Adds ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS and ROS_LOCALHOST_ONLY where the options are not
/// given. Refuses a variable whose value ROS does not have, with its name, and a peer whose name does not resolve.
Result<bus_ros::Network> ros_network(const RosNetworkOptions& options);

}  // namespace farrier::cli
