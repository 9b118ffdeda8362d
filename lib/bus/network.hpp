#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace farrier::bus {

/// The longest that Cyclone takes.
inline constexpr std::chrono::seconds kPatientLease = std::chrono::hours(1);

/// Socket buffer that each vendor requests. A tick's samples from every process fit many times over. The kernel may
/// grant less (net.core.rmem_max, net.core.wmem_max).
inline constexpr unsigned kSocketBufferBytes = 4u << 20;

/// Files that prove a participant's identity and rights to DDS Security: absolute paths. Certificates and the key are
/// PEM, the two documents are XML signed by the permissions CA (S/MIME).
struct SecurityFiles {
  std::string identity_ca;
  std::string certificate;
  std::string private_key;
  std::string permissions_ca;
  std::string governance;
  std::string permissions;
};

/// Addresses at which a DDS process searches the others. The default finds up to `max_processes` processes on this
/// computer by unicast alone: it works on a loopback device without multicast.
struct NetworkOptions {
  int domain = 0;                               ///< DDS domain, 0..232
  std::string address = "127.0.0.1";            ///< address of the one interface DDS uses
  std::vector<std::string> peers{"127.0.0.1"};  ///< computers to look for processes on
  int max_processes = 40;                       ///< per computer
  /// Silence after which the others drop a process. In lock-step a debugger may stop one for long, and its samples
  /// after that would be lost: kPatientLease.
  std::chrono::seconds lease{10};
  /// Samples may wait for some milliseconds before they are received, so that this process wakes up less often. Cyclone
  /// alone does so, for the whole process: not in one that also takes part in a loop.
  bool unhurried = false;
  /// Without it, DDS is not secured. With it, a bus that cannot honour it is refused.
  std::optional<SecurityFiles> security = std::nullopt;
};

}  // namespace farrier::bus
