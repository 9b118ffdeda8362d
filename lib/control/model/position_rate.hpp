#pragma once

#include "plant/terms/first_order_lag.hpp"

namespace farrier::control {

/// Velocity from positions: s / (tau s + 1), exact for a position that is a straight line between samples. White noise
/// of the position comes out at most 1 / tau times as large. Default: none.
class PositionRate {
 public:
  PositionRate() = default;
  /// Both > 0.
  PositionRate(double time_constant_s, double period_s) noexcept
      : time_constant_s_(time_constant_s), slow_(time_constant_s, period_s) {}

  bool active() const noexcept { return time_constant_s_ > 0.0; }
  /// The first position is taken to have been there forever.
  double take(double position) noexcept { return (position - slow_.take(position)) / time_constant_s_; }

 private:
  double time_constant_s_ = 0.0;
  plant::FirstOrderLag<double> slow_{1.0, 1.0};
};

}  // namespace farrier::control
