#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "core/time.hpp"

namespace farrier::participant {

/// Samples of one key as they come from one sender, on the receiver's steady clock. The sender's clock counts by
/// differences only: the quickest way so far is taken for the way that nothing held up.
class Arrival {
 public:
  /// Silence after which a sender may have begun anew.
  static constexpr Nanoseconds kRestart = std::chrono::milliseconds(100);
  /// By how much two steady clocks may drift apart (crystals are within 50 ppm each).
  static constexpr double kDrift = 1e-4;

  /// When this sample would have come had nothing held it up, at most `now`; nothing for one that is no newer than the
  /// newest so far, while its sender is not silent. `sampled_ns`: the sender's steady clock.
  std::optional<SteadyTime> take(Tick tick, std::int64_t sampled_ns, SteadyTime now) noexcept {
    const bool anew = heard_ == SteadyTime{} || now - heard_ > kRestart;
    if (!anew && tick <= newest_) {
      return std::nullopt;
    }
    const Nanoseconds way = now.time_since_epoch() - Nanoseconds(sampled_ns);
    const auto drift = std::chrono::duration_cast<Nanoseconds>(kDrift * (now - heard_));
    quickest_ = anew ? way : std::min(way, quickest_ + drift);
    newest_ = tick;
    heard_ = now;
    return now - (way - quickest_);
  }

 private:
  Tick newest_ = kNoTick;
  SteadyTime heard_{};
  Nanoseconds quickest_{};
};

}  // namespace farrier::participant
