#pragma once

// Foxglove's WebSocket protocol, the server's side of what a viewer needs: https://github.com/foxglove/ws-protocol,
// docs/spec.md. Texts are JSON with "op", bytes begin with an opcode.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ros_view/robot_messages.hpp"

namespace farrier::foxglove {

/// Names of the protocol in Sec-WebSocket-Protocol. Both mean the same messages.
inline constexpr const char* kSubprotocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// True if a value of Sec-WebSocket-Protocol has one of kSubprotocols.
bool offers_subprotocol(std::string_view header);

enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// Server information: its name, and that it takes nothing from viewers.
std::string server_info(const std::string& name, const std::string& session);
/// A channel for each topic; the id is its place.
std::string advertisement(const std::vector<ros_view::Topic>& topics);
std::string status(StatusLevel level, const std::string& message);

/// A message of a topic as bytes for a subscription.
void append_message(std::vector<std::uint8_t>& bytes, std::uint32_t subscription, std::uint64_t time_ns,
                    std::span<const std::uint8_t> cdr);

/// The channels that one viewer has subscribed to.
class Subscriptions {
 public:
  explicit Subscriptions(std::size_t channels) : ids_(channels) {}

  /// Effect of a text of the viewer.
  struct Outcome {
    std::vector<std::size_t> begun;     ///< channels
    std::vector<std::string> problems;  ///< sentences; what else the text says counts all the same
  };
  Outcome take(std::string_view text);

  /// The viewer's number of its subscription to a channel; none: it has none.
  std::optional<std::uint32_t> id(std::size_t channel) const { return ids_[channel]; }

 private:
  std::vector<std::optional<std::uint32_t>> ids_;  // by channel
};

}  // namespace farrier::foxglove
