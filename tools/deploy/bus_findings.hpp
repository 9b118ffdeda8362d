#pragma once

#include <string>

#include "bus/discovery.hpp"
#include "bus/network.hpp"
#include "tools/deploy/finding.hpp"

namespace farrier::deploy {

/// Why a robot's samples do not arrive, as far as discovery shows it: nobody there, endpoints of another robot's
/// partition, topics and types that are not of the contract, writers and readers whose QoS do not go together, several
/// writers where one belongs, clocks that differ. `network` is where was looked, for what is said.
Findings bus_findings(const bus::Discovery& found, const std::string& robot, const bus::NetworkOptions& network);

}  // namespace farrier::deploy
