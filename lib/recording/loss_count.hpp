#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>

#include "bus/key.hpp"
#include "bus/topics.hpp"
#include "signals/sequence_of.hpp"

namespace farrier::recording {

/// Counts the lost samples of one topic, from the gaps in the sequence numbers of its streams. Samples before the first
/// and after the last are not counted. A stream that restarts, with another process, is not a loss.
template <class Signal>
class LossCount {
 public:
  void heard(const Signal& signal) {
    const std::optional<std::uint64_t> sequence = signals::sequence_of(signal);
    if (!sequence) {
      return;
    }
    auto [last, first] = last_.try_emplace(bus::key_of(signal), *sequence);
    if (!first && *sequence > last->second) {
      lost_ += *sequence - last->second - 1;
    }
    last->second = *sequence;
  }
  std::uint64_t lost() const noexcept { return lost_; }

 private:
  std::unordered_map<std::uint32_t, std::uint64_t> last_;  // by key
  std::uint64_t lost_ = 0;
};

}  // namespace farrier::recording
