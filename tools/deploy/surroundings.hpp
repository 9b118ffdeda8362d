#pragma once

#include <string>

#include "tools/deploy/finding.hpp"
#include "tools/deploy/host_facts.hpp"

namespace farrier::deploy {

/// Shared memory that Fast DDS processes left behind when they were killed. Farrier's use none; processes of others
/// that do may fail to find each other over it. `folder` is /dev/shm.
Findings leftover_findings(const std::string& folder);

/// Effects of the environment on every DDS process that is started with it.
Findings environment_findings();

/// Reports that an interface has no multicast, by which some programs search others.
Findings multicast_findings(const HostFacts& facts, const std::string& address);

}  // namespace farrier::deploy
