#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mcap/bytes.hpp"
#include "mcap/record_bytes.hpp"
#include "mcap/records.hpp"

namespace farrier::mcap {

/// Time and place of a message in a chunk; laid out as MCAP's index of messages has it.
struct MessagePlace {
  std::uint64_t time_ns;
  std::uint64_t offset;
};
static_assert(sizeof(MessagePlace) == 16);

/// Messages that go to a file together, as its records. The thread that makes them needs no access to the file.
class Chunk {
 public:
  void write(const Message& message) {
    first_ns_ = messages_ == 0 ? message.log_time_ns : std::min(first_ns_, message.log_time_ns);
    last_ns_ = std::max(last_ns_, message.log_time_ns);
    ++messages_;
    if (places_.size() <= message.channel_id) {
      places_.resize(message.channel_id + std::size_t{1});
    }
    places_[message.channel_id].push_back({message.log_time_ns, records_.size()});
    append(records_, message);
  }
  void write(const Schema& schema) { append(records_, schema); }
  void write(const Channel& channel) { append(records_, channel); }

  /// Keeps the memory.
  void clear() noexcept {
    records_.clear();
    for (auto& places : places_) {
      places.clear();
    }
    first_ns_ = last_ns_ = messages_ = 0;
  }

  std::span<const std::uint8_t> records() const noexcept { return records_.view(); }
  std::size_t size() const noexcept { return records_.size(); }
  std::uint64_t messages() const noexcept { return messages_; }
  /// Smallest and largest log time of the messages; 0 without one.
  std::uint64_t first_ns() const noexcept { return first_ns_; }
  std::uint64_t last_ns() const noexcept { return last_ns_; }
  /// By channel; there may be fewer than channels.
  const std::vector<std::vector<MessagePlace>>& places() const noexcept { return places_; }

 private:
  ByteWriter records_;
  std::uint64_t first_ns_ = 0, last_ns_ = 0, messages_ = 0;
  std::vector<std::vector<MessagePlace>> places_;
};

}  // namespace farrier::mcap
