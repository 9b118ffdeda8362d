#pragma once

#include <string>

#include "bus/discovery.hpp"
#include "bus/network.hpp"
#include "tools/deploy/finding.hpp"

namespace farrier::deploy {

/// Reasons why a robot's samples do not arrive, as far as discovery shows them. There may be no process, or only
/// endpoints of another robot's partition. Topics and types may differ from the contract, and QoS of writer and reader
/// may not match. A topic may have several writers instead of one, and clocks may differ. `network` is the place of the
/// search, for messages.
Findings bus_findings(const bus::Discovery& found, const std::string& robot, const bus::NetworkOptions& network);

}  // namespace farrier::deploy
