#include "control/law/pid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/portable_math.hpp"

namespace farrier::control {

Pid::Pid(const PidGains& gains, const Normalisation& normalisation, double period_s) noexcept
    : gains_(gains),
      normalisation_(normalisation),
      period_s_(period_s),
      filter_keeps_(portable::exp(-2.0 * std::numbers::pi * gains.derivative_filter_Hz * period_s)) {}

Pid::Output Pid::step(double force_reference, const Measurement& measurement) noexcept {
  const double error = (force_reference - measurement.force) / normalisation_.force;
  // d[k] = c d[k-1] + (1 - c) (e[k] - e[k-1]) / T, c = exp(-w_f T)
  const double difference_1_s = has_run_ ? (error - last_error_) / period_s_ : 0.0;
  const double rate_1_s = filter_keeps_ * rate_1_s_ + (1.0 - filter_keeps_) * difference_1_s;
  const double wanted = gains_.proportional * error + integral_ + gains_.derivative_s * rate_1_s;
  if (!std::isfinite(wanted)) {
    return {0.0, false};
  }
  last_error_ = error;
  rate_1_s_ = rate_1_s;
  has_run_ = true;
  const double share = std::clamp(wanted, -1.0, 1.0);
  const bool saturated = share != wanted;
  if (!saturated || error * wanted < 0.0) {
    integral_ = std::clamp(integral_ + gains_.integral_1_s * period_s_ * error, -1.0, 1.0);
  }
  return {share * normalisation_.current_A, saturated};
}

void Pid::reset() noexcept {
  integral_ = 0.0;
  last_error_ = 0.0;
  rate_1_s_ = 0.0;
  has_run_ = false;
}

}  // namespace farrier::control
