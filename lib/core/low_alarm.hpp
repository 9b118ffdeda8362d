#pragma once

namespace farrier {

/// Alarm for a value that is too low, with hysteresis: on below one limit, off at or above a higher one. A value that is
/// not finite is low.
class LowAlarm {
 public:
  /// `low` <= `recovered`.
  constexpr LowAlarm(double low, double recovered) noexcept : low_(low), recovered_(recovered) {}

  /// Takes a value. Returns true while the alarm is on.
  constexpr bool step(double value) noexcept {
    on_ = !(value >= (on_ ? recovered_ : low_));
    return on_;
  }
  constexpr bool on() const noexcept { return on_; }

 private:
  double low_, recovered_;
  bool on_ = false;
};

}  // namespace farrier
