#pragma once

#include <dds/dds.h>

#include <string>

#include "bus_ros/ros_network.hpp"
#include "core/result.hpp"

namespace farrier::bus_ros {

/// Cyclone's configuration of a domain of ROS 2, as XML: that of rmw_cyclonedds for the same discovery range.
std::string ros_config(const Network& network);

/// Opens a domain with sockets of its own, beside any other of this process; deleting it ends all its entities.
Result<dds_entity_t> open_ros_domain(const Network& network);

/// A participant of that domain with the user data of a ROS context: "enclave=/;".
Result<dds_entity_t> join_ros_domain(dds_entity_t domain);

}  // namespace farrier::bus_ros
