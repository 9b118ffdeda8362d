#pragma once

#include "robot/robot.hpp"
#include "tools/deploy/deployed_processes.hpp"
#include "tools/deploy/finding.hpp"
#include "tools/deploy/host_facts.hpp"

namespace farrier::deploy {

/// Obstacles to deadlines of 1 kHz loops on this computer: priorities, locked memory, the kernel.
Findings realtime_findings(const HostFacts& facts, int priority);

/// Socket buffers smaller than DDS asks for.
Findings buffer_findings(const HostFacts& facts);

/// Reports if the address is not that of an interface which is up. `interface` may be empty: any.
Findings address_findings(const HostFacts& facts, const std::string& address, const std::string& interface);

/// Requirements of a deployment on the computer that is this host of it, except its files: address and processors. On
/// the real-time clock they also include priorities, memory, kernel and how soon it is heard again after a cut.
Findings host_findings(const HostFacts& facts, const robot::Deployment& deployment, const robot::Host& host);

/// Reports missing executables, and rendered files that differ from a new rendering. `rendered`: those that differ, of
/// Places::folder.
Findings file_findings(const std::vector<DeployedProcess>& processes, const Places& places,
                       const std::vector<std::string>& differing);

}  // namespace farrier::deploy
