#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace farrier::deploy {

/// A network interface with one of its IPv4 addresses; one without address has an empty one.
struct Interface {
  std::string name;
  std::string address;
  bool up = false;  ///< and with a cable where it takes one
  bool multicast = false;
  std::uint64_t address_retry_ms = 0;  ///< net.ipv4.neigh.<name>.retrans_time_ms; 0: not known
};

/// Facts of a computer.
struct HostFacts {
  std::string name;                    ///< of the computer
  std::vector<Interface> interfaces;
  std::vector<int> cpus;               ///< processors that are on
  bool realtime_kernel = false;
  std::string kernel;                  ///< its release
  std::uint64_t receive_buffer_max = 0;  ///< net.core.rmem_max, bytes
  std::uint64_t send_buffer_max = 0;     ///< net.core.wmem_max, bytes
  std::string lacks_priority;          ///< why a process of this user gets no real-time priority; empty: it does
  std::string lacks_locked_memory;     ///< the same of locked memory
  std::string lacks_awake_processors;  ///< the same of processors that do not sleep
  std::uint64_t rtprio_limit = 0;      ///< RLIMIT_RTPRIO
  std::uint64_t memlock_limit = 0;     ///< RLIMIT_MEMLOCK, bytes; all ones: no limit
};

/// Asks the kernel. A process of its own, which ends at once, tries to get a priority, locked memory and processors
/// kept out of idle states. `priority` is the SCHED_FIFO priority that is tried.
HostFacts this_host(int priority);

/// "0-3,6" as /sys and cpusets write processors.
std::vector<int> parse_cpu_list(const std::string& text);

}  // namespace farrier::deploy
