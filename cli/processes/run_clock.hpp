#pragma once

#include <algorithm>

#include "core/time.hpp"

namespace farrier::cli {

/// The tick of a run. It is the newest that its clock has begun or, once the clock is stopped, the one it would have
/// begun.
class RunClock {
 public:
  /// `tick_time`: duration of one tick on participant::steady_now; zero if ticks have no fixed duration.
  explicit RunClock(Nanoseconds tick_time) noexcept : tick_time_(tick_time) {}

  /// The newest tick that the clock has begun is known to be `tick`.
  void heard(Tick tick, SteadyTime now) noexcept {
    if (tick != newest_) {
      newest_ = tick;
      since_ = now;
    }
  }

  /// Ticks arrive in bunches, so the clock counts as running during a few ticks without news.
  Tick at(SteadyTime now) const noexcept {
    constexpr Tick kStandsStill = 4;
    if (newest_ <= 0 || tick_time_ <= Nanoseconds::zero()) {
      return newest_;
    }
    const Tick since = (now - since_) / tick_time_;
    return since > kStandsStill ? newest_ + since : newest_;
  }

 private:
  Nanoseconds tick_time_;
  Tick newest_ = 0;
  SteadyTime since_{};
};

}  // namespace farrier::cli
