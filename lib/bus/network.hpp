#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace farrier::bus {

/// The longest that Cyclone takes.
inline constexpr std::chrono::seconds kPatientLease = std::chrono::hours(1);

/// What each vendor asks for its sockets: a tick's worth of samples from every process fits many times over. The kernel
/// may grant less (net.core.rmem_max, net.core.wmem_max).
inline constexpr unsigned kSocketBufferBytes = 4u << 20;

/// What a participant proves its identity and its rights by, for DDS Security: absolute paths. Certificates and the
/// key are PEM, the two documents are XML signed by the permissions CA (S/MIME).
struct SecurityFiles {
  std::string identity_ca;
  std::string certificate;
  std::string private_key;
  std::string permissions_ca;
  std::string governance;
  std::string permissions;
};

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
  /// Without, DDS is open to everybody; with, a bus that cannot honour it is refused.
  std::optional<SecurityFiles> security;
};

}  // namespace farrier::bus
