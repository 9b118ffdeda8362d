#include "cli/ros/ros_network.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include "bus/settings/peer_address.hpp"
#include "cli/base/help.hpp"

namespace farrier::cli {
namespace {

using bus_ros::Discovery;

constexpr int kMaxDomain = 232;
constexpr const char* kDomainVariable = "ROS_DOMAIN_ID";
constexpr const char* kRangeVariable = "ROS_AUTOMATIC_DISCOVERY_RANGE";
constexpr const char* kPeersVariable = "ROS_STATIC_PEERS";
constexpr const char* kLocalhostVariable = "ROS_LOCALHOST_ONLY";
constexpr const char* kLoopback = "127.0.0.1";

/// A variable of the environment; empty where it is not set.
std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

Result<int> domain_of_environment() {
  const std::string text = variable(kDomainVariable);
  if (text.empty()) {
    return 0;
  }
  int domain = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), domain);
  if (error != std::errc() || end != text.data() + text.size() || domain < 0 || domain > kMaxDomain) {
    return Error{std::string(kDomainVariable) + " is '" + text + "': set it to a number from 0 to " +
                 std::to_string(kMaxDomain) + ", or give --ros-domain"};
  }
  return domain;
}

/// The range by its name in ROS. SYSTEM_DEFAULT and no name leave the choice to us: this computer.
Result<Discovery> discovery_of_environment() {
  constexpr std::array kRanges{
      Option<Discovery>{"LOCALHOST", Discovery::kLocalhost}, Option<Discovery>{"SUBNET", Discovery::kSubnet},
      Option<Discovery>{"OFF", Discovery::kOff}, Option<Discovery>{"SYSTEM_DEFAULT", Discovery::kLocalhost}};
  const std::string text = variable(kRangeVariable);
  if (text.empty()) {
    return Discovery::kLocalhost;
  }
  const auto range = parse_choice("range", kRanges, text);
  if (!range) {
    return Error{std::string(kRangeVariable) + " is '" + text + "': set it to " + names_of(kRanges, ", ") +
                 ", or give --ros-discovery"};
  }
  return range.value();
}

/// Computers of ROS_STATIC_PEERS, which semicolons separate.
Result<std::vector<std::string>> peers_of_environment() {
  std::vector<std::string> peers;
  std::istringstream list(variable(kPeersVariable));
  for (std::string peer; std::getline(list, peer, ';');) {
    if (peer.empty()) {
      continue;
    }
    if (const std::string error = bus::peer_error(peer); !error.empty()) {
      return Error{std::string(kPeersVariable) + ": " + error};
    }
    peers.push_back(peer);
  }
  return peers;
}

}  // namespace

void declare_ros_network(CLI::App& app, RosNetworkOptions& options) {
  app.add_option("--ros-domain", options.domain, "domain of the nodes of ROS 2")
      ->check(CLI::Range(0, kMaxDomain))
      ->type_name("<n>")
      ->default_str("ROS_DOMAIN_ID, else 0");
  add_name(app, "--ros-discovery", options.discovery, bus_ros::kDiscoveries,
           "where nodes are searched: on this computer, on its network by multicast, or nowhere")
      ->default_str("localhost, or what ROS_LOCALHOST_ONLY and ROS_AUTOMATIC_DISCOVERY_RANGE say");
  app.add_option("--ros-address", options.address, "IPv4 address of this computer for ROS 2")
      ->check(bus::address_error)
      ->type_name("<ip>")
      ->default_str("Cyclone's choice");
  app.add_option("--ros-peers", options.peers, "further computers to look for nodes on, by IPv4 address or name")
      ->delimiter(',')
      ->check(bus::peer_error)
      ->type_name("<ip>,...")
      ->default_str("ROS_STATIC_PEERS");
}

Result<bus_ros::Network> ros_network(const RosNetworkOptions& options) {
  bus_ros::Network network;
  network.domain = options.domain ? *options.domain : FARRIER_TRY(domain_of_environment());
  network.address = options.address;
  // ROS_LOCALHOST_ONLY of Humble; later nodes honour it before the other two (rcl, init.c).
  const bool localhost_only = variable(kLocalhostVariable) == "1";
  if (!options.discovery.empty()) {
    network.discovery = parse_choice("discovery", bus_ros::kDiscoveries, options.discovery).value();
  } else if (localhost_only) {
    network.address = options.address.empty() ? kLoopback : options.address;
  } else {
    network.discovery = FARRIER_TRY(discovery_of_environment());
  }
  std::vector<std::string> peers = options.peers;
  if (peers.empty() && (!localhost_only || !options.discovery.empty())) {
    peers = FARRIER_TRY(peers_of_environment());
  }
  for (const std::string& peer : peers) {
    network.peers.push_back(FARRIER_TRY(bus::resolve_peer(peer)));
  }
  return network;
}

}  // namespace farrier::cli
