#pragma once

#include <chrono>
#include <limits>

#include "core/time.hpp"

namespace farrier::participant {

/// Ticks as they come from one sender. A tick that is out of order, or farther ahead than any sender can be, would
/// block or mislead a loop that acts on the newest.
class Sequence {
 public:
  /// Silence after which a sender may have restarted, at any tick.
  static constexpr Nanoseconds kRestart = std::chrono::milliseconds(100);
  /// More ticks than any loop makes within kRestart.
  static constexpr Tick kFarthest = 10'000;

  /// Later than any run, and so early that a tick and a time added to it are still ticks.
  static constexpr Tick kLatest = std::numeric_limits<Tick>::max() / 2;

  /// True if a sample of this tick counts: it is newer than the newest so far and not too far ahead of it, or its
  /// sender may have restarted.
  bool take(Tick tick, SteadyTime now) noexcept {
    const bool may_jump = begins_anew(now);
    if (tick < 0 || tick > kLatest || tick == newest_ ||
        (!may_jump && (tick < newest_ || tick - newest_ > kFarthest))) {
      return false;
    }
    newest_ = tick;
    heard_ = now;
    return true;
  }

  /// True if the next sample may be the first of its sender.
  bool begins_anew(SteadyTime now) const noexcept { return heard_ == SteadyTime{} || now - heard_ > kRestart; }

  SteadyTime heard() const noexcept { return heard_; }  ///< when the last sample counted
  Tick newest() const noexcept { return newest_; }      ///< of the last sample that counted; kNoTick before

 private:
  Tick newest_ = kNoTick;
  SteadyTime heard_{};
};

}  // namespace farrier::participant
