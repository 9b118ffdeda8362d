#pragma once

// The bus over eProsima Fast DDS 2.9: UDP only, unicast on one interface, written on the caller's thread.

#include <memory>

#include "bus/bus.hpp"
#include "bus/network.hpp"
#include "core/result.hpp"

namespace farrier::bus_fastdds {

/// Joins the DDS domain of `options` as one participant with sockets of its own, also when the process already
/// holds another bus of this domain.
///
/// Everything is configured here. A user's FASTRTPS_DEFAULT_PROFILES_FILE is read but changes neither participants
/// nor endpoints, and samples between two buses of one process cross UDP whatever it says.
/// ROS_DISCOVERY_SERVER, which would turn discovery into a server's client, is removed from this process's environment.
///
/// Arrivals are counted on the receive thread. Fast DDS reports several samples at once when a gap in a reliable stream
/// closes. Each of them is counted at least once; in a race with take() some may be counted twice.
Result<std::unique_ptr<bus::Bus>> create_fast_bus(const bus::NetworkOptions& options);

}  // namespace farrier::bus_fastdds
