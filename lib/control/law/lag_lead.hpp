#pragma once

#include <algorithm>

#include "plant/terms/first_order_lag.hpp"

namespace farrier::control {

/// Compensates a sensor's lag of first order, except for a rest: x = (tau s + 1) / (tau_r s + 1) y. White noise is
/// amplified by at most tau / tau_r. Default: y unchanged.
class LagLead {
 public:
  LagLead() = default;

  /// `time_constant_s` > 0. The rest is tau_r = tau / most_gain, but no less than `least_rest_s` > 0; a lag below that
  /// is left unchanged. `period_s` > 0 between calls of take.
  LagLead(double time_constant_s, double most_gain, double least_rest_s, double period_s) noexcept
      : rest_s_(std::min(time_constant_s, std::max(time_constant_s / most_gain, least_rest_s))),
        gain_(time_constant_s / rest_s_),
        rest_(rest_s_, period_s) {}

  /// The first value is assumed to have been constant before.
  double take(double value) noexcept {
    return gain_ == 1.0 ? value : gain_ * value + (1.0 - gain_) * rest_.take(value);
  }

  /// tau_r; 0 by default.
  double rest_s() const noexcept { return rest_s_; }

 private:
  double rest_s_ = 0.0;
  double gain_ = 1.0;
  plant::FirstOrderLag<double> rest_{1.0, 1.0};
};

}  // namespace farrier::control
