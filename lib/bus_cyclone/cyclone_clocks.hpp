#pragma once

#include <dds/dds.h>

#include <vector>

#include "bus/discovery.hpp"
#include "core/time.hpp"

namespace farrier::bus_cyclone {

/// Listens for that long to the health reports of every robot in the domain and compares the times at which they were
/// written with those at which they arrive.
std::vector<bus::DiscoveredClock> compare_clocks(dds_entity_t participant, Nanoseconds how_long);

}  // namespace farrier::bus_cyclone
