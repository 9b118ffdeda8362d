#pragma once

#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tools/foxglove/protocol.hpp"

namespace farrier::foxglove {

/// A message of a topic, shared by those who get it.
struct SharedMessage {
  std::size_t topic;
  std::uint64_t time_ns;
  std::vector<std::uint8_t> cdr;
};

/// One viewer that is connected: what it has subscribed to, and what waits until its connection takes it. The queue is
/// bounded: old messages go first, and are counted.
class Viewer {
 public:
  static constexpr std::size_t kMostWaitingBytes = 4u << 20;
  /// Texts, and messages that are kept for late joiners, are not dropped. Beyond this sum the viewer has to go.
  static constexpr std::size_t kMostOwedBytes = 8u << 20;
  static constexpr std::size_t kLargestText = 64u << 10;

  explicit Viewer(std::size_t channels) : subscriptions_(channels) {}

  /// Part of a text of the viewer. False: the text is too long.
  bool take(std::string_view part, bool last);
  /// Channels that a text has subscribed to since the last call.
  std::vector<std::size_t> begun() { return std::exchange(begun_, {}); }

  /// A text that waits.
  void say(std::string text);
  /// A message that is new, if the viewer has subscribed to its topic.
  void offer(const std::shared_ptr<const SharedMessage>& message);
  /// A message that is kept, which is not dropped.
  void owe(const SharedMessage& message);

  /// True if so much is owed that the viewer is to be closed.
  bool is_hopeless() const noexcept { return owed_bytes_ > kMostOwedBytes; }
  bool has_waiting() const noexcept { return !owed_.empty() || !waiting_.empty(); }

  /// Appends what is to be sent next to `bytes`; true for a text, false for bytes.
  bool pop(std::vector<std::uint8_t>& bytes);

  std::uint64_t dropped() const noexcept { return dropped_; }
  std::uint64_t sent() const noexcept { return sent_; }

 private:
  struct Owed {
    bool is_text;
    std::vector<std::uint8_t> bytes;
  };

  Subscriptions subscriptions_;
  std::string text_;  // as far as it has come
  std::vector<std::size_t> begun_;
  std::deque<Owed> owed_;
  std::deque<std::shared_ptr<const SharedMessage>> waiting_;
  std::size_t owed_bytes_ = 0, waiting_bytes_ = 0;
  std::uint64_t dropped_ = 0, told_ = 0, sent_ = 0;
};

}  // namespace farrier::foxglove
