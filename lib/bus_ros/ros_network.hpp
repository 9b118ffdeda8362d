#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/choice.hpp"

namespace farrier::bus_ros {

/// Where nodes of ROS 2 are searched, as ROS_AUTOMATIC_DISCOVERY_RANGE has it.
enum class Discovery {
  kLocalhost,  ///< on this computer, by unicast
  kSubnet,     ///< on the network of the interface, by multicast
  kOff,        ///< nowhere: no node finds this one, and it finds none
};
inline constexpr std::array kDiscoveries{Option<Discovery>{"localhost", Discovery::kLocalhost},
                                         Option<Discovery>{"subnet", Discovery::kSubnet},
                                         Option<Discovery>{"off", Discovery::kOff}};

/// Form of the graph message, ros_discovery_info, which tells other nodes this node's name and endpoints.
enum class Graph {
  kAuto,    ///< that of the nodes that are there; none while there are none, and while both kinds are there
  kHumble,  ///< gids of 24 bytes
  kJazzy,   ///< gids of 16 bytes: Iron and later. Nodes of Humble crash on it
  kNone,    ///< none: topics work, the node has no name
};
inline constexpr std::array kGraphs{Option<Graph>{"auto", Graph::kAuto}, Option<Graph>{"humble", Graph::kHumble},
                                    Option<Graph>{"jazzy", Graph::kJazzy}, Option<Graph>{"none", Graph::kNone}};

/// The DDS domain of ROS 2.
struct Network {
  int domain = 0;  ///< ROS_DOMAIN_ID, 0..232
  Discovery discovery = Discovery::kLocalhost;
  std::string address;             ///< of the one interface that is used; empty: Cyclone's choice
  std::vector<std::string> peers;  ///< further computers to look for nodes on
};

}  // namespace farrier::bus_ros
