#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "participant/sequence.hpp"

namespace farrier::participant {

/// Arrival times of one sender's samples of one key, on the receiver's steady clock. Only differences of the sender's
/// clock count: the shortest transport so far is taken as the transport without delay.
class Arrival {
 public:
  /// Largest drift between two steady clocks (crystals are within 50 ppm each).
  static constexpr double kDrift = 1e-4;

  /// No transport takes longer than the quickest by this while the sender is heard. Otherwise the quickest was a wrong
  /// stamp's.
  static constexpr Nanoseconds kLongest = std::chrono::seconds(1);

  /// Returns the time at which this sample would have come without delay, at most `now`. Returns nothing if the tick
  /// does not count (Sequence) or no steady clock gives such a stamp. Also returns nothing if the sample is quicker
  /// than any before by more than Sequence::kRestart: one wrong stamp must not make all after it late. `sampled_ns`:
  /// the sender's steady clock.
  std::optional<SteadyTime> take(Tick tick, std::int64_t sampled_ns, SteadyTime now) noexcept {
    constexpr std::int64_t kLatestStamp_ns = std::numeric_limits<std::int64_t>::max() / 4;  // 73 years
    if (sampled_ns < 0 || sampled_ns > kLatestStamp_ns) {
      return std::nullopt;
    }
    const Nanoseconds way = now.time_since_epoch() - Nanoseconds(sampled_ns);
    const SteadyTime before = sequence_.heard();
    const bool anew = sequence_.begins_anew(now);
    if ((!anew && quickest_ - way > Sequence::kRestart) || !sequence_.take(tick, now)) {
      return std::nullopt;
    }
    // Samples that were delayed while this process or its sender was stopped come late after a silence: the clock is
    // the same.
    const bool same_clock = !anew || (before != SteadyTime{} && way >= quickest_ && way - quickest_ <= kLongest);
    const auto drift = std::chrono::duration_cast<Nanoseconds>(kDrift * (now - before));
    const Nanoseconds quickest = same_clock ? std::min(way, quickest_ + drift) : way;
    quickest_ = way - quickest > kLongest ? way : quickest;
    return now - (way - quickest);
  }

 private:
  Sequence sequence_;
  Nanoseconds quickest_{};
};

}  // namespace farrier::participant
