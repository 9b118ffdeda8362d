#pragma once

#include <memory>

#include "bus/bus.hpp"
#include "bus/discovery.hpp"
#include "bus/network.hpp"

namespace farrier::bus_factory {

/// The bus of a process over the vendor chosen at start. The in-process bus is not among them: it joins nodes of one
/// process, which lib/run does. Peers may be names. Refuses those that do not resolve, see bus/settings/peer_address.hpp.
Result<std::unique_ptr<bus::Bus>> create_bus(bus::Vendor vendor, const bus::NetworkOptions& network);

/// Looks into a domain for that long: who takes part, of whichever vendor, and what they write and read.
Result<bus::Discovery> discover(const bus::NetworkOptions& network, Nanoseconds how_long);

}  // namespace farrier::bus_factory
