#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "tools/foxglove/protocol.hpp"
#include "tools/monitor/listen_address.hpp"

namespace farrier::foxglove {

/// Counts since the server began.
struct ServerCounts {
  std::uint64_t viewers = 0;  ///< that have been connected
  std::uint64_t sent = 0;     ///< messages
  std::uint64_t dropped = 0;  ///< messages that slow viewers left no room for
};

/// A server of Foxglove's protocol, on a thread of its own. Viewers can only read. Each has a queue of its own: one that
/// reads slowly loses messages, and delays nobody.
class FoxgloveServer {
 public:
  static constexpr int kMostViewers = 32;

  /// `name`: as viewers show it. Refuses an address that cannot be had. Messages of kept topics go to late joiners, the
  /// newest `depth` of each.
  static Result<std::unique_ptr<FoxgloveServer>> create(const display::ListenAddress& address, const std::string& name,
                                                        std::vector<ros_view::Topic> topics);
  ~FoxgloveServer();
  FoxgloveServer(const FoxgloveServer&) = delete;
  FoxgloveServer& operator=(const FoxgloveServer&) = delete;

  /// Sends a message of the topic of this place to all who have subscribed to it. Never waits for a viewer.
  void send(std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr);

  int port() const noexcept;
  ServerCounts counts() const;

 private:
  class Impl;
  explicit FoxgloveServer(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace farrier::foxglove
