#pragma once

#include <string>
#include <vector>

#include "tools/deploy/deployed_processes.hpp"

namespace farrier::deploy {

/// Period at which a host asks again for the address of one that does not answer. Linux waits a second. For so long a
/// host whose cable was out hears all others and no host hears it.
inline constexpr int kAddressRetry_ms = 20;

struct RenderedFile {
  std::string name;
  std::string text;
};

/// Everything a host needs beside the packages: a systemd unit per process and a target for all of them, the kernel's
/// settings for its network, and `robot_text`, the robot file they are of. Refuses as processes_of.
Result<std::vector<RenderedFile>> render_host(const robot::Robot& robot, const std::string& robot_text,
                                              const std::string& host, const Places& places);

/// Name of the unit that starts and stops all of a robot's processes on a host: "farrier-hyq.target".
std::string target_of(const robot::Robot& robot);

/// Name of the unit of a process: "farrier-hyq-supervisor.service".
std::string unit_of(const robot::Robot& robot, const std::string& process);

}  // namespace farrier::deploy
