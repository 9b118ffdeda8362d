#pragma once

#include "robot/robot.hpp"
#include "tools/deploy/deployed_processes.hpp"
#include "tools/deploy/finding.hpp"
#include "tools/deploy/host_facts.hpp"

namespace farrier::deploy {

/// What keeps loops of 1 kHz from their deadlines here: priorities, locked memory, the kernel.
Findings realtime_findings(const HostFacts& facts, int priority);

/// Socket buffers smaller than DDS asks for.
Findings buffer_findings(const HostFacts& facts);

/// Whether the address is that of an interface which is up. `interface` may be empty: any.
Findings address_findings(const HostFacts& facts, const std::string& address, const std::string& interface);

/// What a deployment asks of the computer that is this host of it, its files aside: address, processors, and on the
/// real-time clock priorities, memory, kernel and how soon it is heard again after a cut.
Findings host_findings(const HostFacts& facts, const robot::Deployment& deployment, const robot::Host& host);

/// Executables that are not there, and rendered files that are not what would be rendered now. `rendered`: those that
/// differ, of Places::folder.
Findings file_findings(const std::vector<DeployedProcess>& processes, const Places& places,
                       const std::vector<std::string>& differing);

}  // namespace farrier::deploy
