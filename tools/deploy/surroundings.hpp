#pragma once

#include <string>

#include "bus/network.hpp"
#include "tools/deploy/finding.hpp"
#include "tools/deploy/host_facts.hpp"

namespace farrier::deploy {

/// Shared memory that Fast DDS processes left behind when they were killed. Farrier's use none; processes of others
/// that do may fail to find each other over it. `folder` is /dev/shm.
Findings leftover_findings(const std::string& folder);

/// DDS settings of the environment, one note each, with file and line: whether they act on Farrier's processes.
Findings environment_findings(const bus::NetworkOptions& network);

/// Reports that an interface has no multicast, by which some programs search others.
Findings multicast_findings(const HostFacts& facts, const std::string& address);

}  // namespace farrier::deploy
