#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace farrier::bus {

/// The longest that Cyclone takes.
inline constexpr std::chrono::seconds kPatientLease = std::chrono::hours(1);

/// What each vendor asks for its sockets: a tick's worth of samples from every process fits many times over. The kernel
/// may grant less (net.core.rmem_max, net.core.wmem_max).
inline constexpr unsigned kSocketBufferBytes = 4u << 20;

/// Where a DDS process looks for the others. The default finds up to `max_processes` processes on this computer by
/// unicast alone: it works on a loopback device without multicast.
struct NetworkOptions {
  int domain = 0;                              ///< DDS domain, 0..232
  std::string address = "127.0.0.1";           ///< address of the one interface DDS uses
  std::vector<std::string> peers{"127.0.0.1"}; ///< computers to look for processes on
  int max_processes = 40;                      ///< per computer
  /// Silence after which a process is forgotten by the others. In lock-step a debugger may hold one for long, and
  /// what it wrote after that would be lost: kPatientLease.
  std::chrono::seconds lease{10};
};

}  // namespace farrier::bus
