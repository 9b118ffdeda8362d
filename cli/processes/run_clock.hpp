#pragma once

#include <algorithm>

#include "core/time.hpp"

namespace farrier::cli {

/// The tick of a run: what its clock has begun or, once the clock stands still, what it would have begun since.
class RunClock {
 public:
  /// `tick_time`: of one tick on participant::steady_now; zero where ticks take what they take.
  explicit RunClock(Nanoseconds tick_time) noexcept : tick_time_(tick_time) {}

  /// The newest tick that the clock has begun is known to be `tick`.
  void heard(Tick tick, SteadyTime now) noexcept {
    if (tick != newest_) {
      newest_ = tick;
      since_ = now;
    }
  }

  /// Ticks are heard of in bunches: the clock does not stand still for some without.
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
