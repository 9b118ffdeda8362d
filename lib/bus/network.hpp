#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace farrier::bus {

/// The longest that Cyclone takes.
inline constexpr std::chrono::seconds kPatientLease = std::chrono::hours(1);

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
