#pragma once

#include <cstdint>
#include <string>

#include "core/result.hpp"

namespace farrier::display {

/// Where a server of the monitor listens.
struct ListenAddress {
  std::string ip;
  std::uint16_t port = 0;  ///< 0: any that is free
  bool v6 = false;

  /// "127.0.0.1:9464", "[::1]:9464"
  std::string text() const { return (v6 ? "[" + ip + "]" : ip) + ":" + std::to_string(port); }
};

/// Reads "127.0.0.1:9464", "[::1]:9464" or ":9464", which is the loopback address. "0.0.0.0:9464" is all addresses of
/// this computer. Refuses any other text.
Result<ListenAddress> parse_listen_address(const std::string& text);

/// Refuses an address or a port that cannot be had now, with the system's reason.
Result<Done> check_listening(const ListenAddress& address);

}  // namespace farrier::display
