#pragma once

#include <cstdint>

#include "core/time.hpp"

namespace farrier::recorder {

/// How long somebody who takes every sample of a lock-step run may sleep. The tick ends when the last of its samples has
/// come, so he wakes at half of what is still to come, again at half of the rest, and so on: a few times a tick instead of
/// once a sample.
class ArrivalPace {
 public:
  /// The count of arrivals to sleep until, with `arrivals` of them behind and `tick` the newest that has begun. At least
  /// one more.
  std::uint64_t next(Tick tick, std::uint64_t arrivals) noexcept {
    if (tick != tick_) {
      of_a_tick_ = tick > tick_ ? (arrivals - began_) / static_cast<std::uint64_t>(tick - tick_) : 0;
      began_ = arrivals;
      tick_ = tick;
    }
    const std::uint64_t end = began_ + of_a_tick_;
    return arrivals + (end > arrivals + 1 ? (end - arrivals) / 2 : 1);
  }

 private:
  Tick tick_ = 0;
  std::uint64_t began_ = 0;      ///< arrivals when the tick began
  std::uint64_t of_a_tick_ = 0;  ///< arrivals in the tick before
};

}  // namespace farrier::recorder
