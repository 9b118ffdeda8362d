#include "supervisor/update_method.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::supervisor {

using signals::UpdateVerdict;

LimitedGains::LimitedGains(const robot::UpdateLogicParams& logic, int estimate_period_ticks,
                           double estimate_period_s) noexcept
    : logic_(logic), estimate_period_s_(estimate_period_s), held_(estimate_period_ticks) {}

UpdateVerdict LimitedGains::before_design(const Evidence& evidence) noexcept {
  if (!designed_ || !evidence.valid) {
    restart();
  }
  designed_ = !evidence.valid;  // none to wait for
  return evidence.valid ? UpdateVerdict::kAccepted : UpdateVerdict::kNotValid;
}

// |k[i] - k[i-1]| <= rate T max(|k[i]|, |k[i-1]|)
bool LimitedGains::slow(const Parts& now) const noexcept {
  const auto within = [&](double change, double before, double after, double rate_1_s) {
    return change <= rate_1_s * estimate_period_s_ * std::max(before, after);
  };
  return within((now.state - last_.state).norm(), last_.state.norm(), now.state.norm(),
                logic_.state_gain_rate_max_1_s) &&
         within(std::abs(now.integral - last_.integral), std::abs(last_.integral), std::abs(now.integral),
                logic_.integral_gain_rate_max_1_s) &&
         within(std::abs(now.feed_forward - last_.feed_forward), std::abs(last_.feed_forward),
                std::abs(now.feed_forward), logic_.feed_forward_rate_max_1_s);
}

UpdateVerdict LimitedGains::after_design(const control::Gains& gains) noexcept {
  designed_ = true;
  const Parts now{{gains.position, gains.velocity, gains.force}, gains.integral, gains.feed_forward};
  if (!(now.state.norm() <= logic_.state_gain_max && std::abs(now.integral) <= logic_.integral_gain_max &&
        std::abs(now.feed_forward) <= logic_.feed_forward_max)) {
    restart();
    return UpdateVerdict::kGainsTooLarge;
  }
  if (held_.ever() && slow(now)) {
    held_.again();
  } else {
    held_.from_now();
  }
  last_ = now;
  return held_.ticks() < logic_.converged_ticks ? UpdateVerdict::kGainsChangeFast : UpdateVerdict::kAccepted;
}

PredictionError::PredictionError(const robot::UpdateLogicParams& logic, int estimate_period_ticks) noexcept
    : logic_(logic), held_(estimate_period_ticks) {}

UpdateVerdict PredictionError::before_design(const Evidence& evidence) noexcept {
  const bool small = evidence.prediction_error <= logic_.prediction_error_max;
  const bool white =
      logic_.method != robot::UpdateMethod::kWhiteError || evidence.whiteness >= logic_.whiteness_min;
  if (!small || !white || !evidence.valid) {
    restart();
    return !small ? UpdateVerdict::kErrorTooLarge : !white ? UpdateVerdict::kErrorNotWhite : UpdateVerdict::kNotValid;
  }
  held_.again();
  return held_.ticks() < logic_.converged_ticks ? UpdateVerdict::kNotConverged : UpdateVerdict::kAccepted;
}

DistinctPoles::DistinctPoles(const robot::UpdateLogicParams& logic, control::Form form,
                             int estimate_period_ticks) noexcept
    : logic_(logic), form_(form), held_(estimate_period_ticks) {}

void DistinctPoles::follow(const PoleSet& poles) noexcept {
  const double moved = held_.ever() ? distance(poles, anchor_, form_) : INFINITY;
  if (moved <= logic_.pole_spread_max) {
    held_.again();
    spread_ = std::max(spread_, moved);
  } else {
    anchor_ = poles;
    held_.from_now();
    spread_ = 0;
  }
}

UpdateVerdict DistinctPoles::before_design(const Evidence& evidence) noexcept {
  follow(evidence.poles);
  if (evidence.pole_distance <= logic_.pole_distance_min &&
      std::max(evidence.gain_ratio, 1.0 / evidence.gain_ratio) <= logic_.gain_ratio_min) {
    return UpdateVerdict::kNotDifferentEnough;
  }
  if (held_.ticks() < logic_.converged_ticks) {
    return UpdateVerdict::kNotConverged;
  }
  return evidence.valid ? UpdateVerdict::kAccepted : UpdateVerdict::kNotValid;
}

Method make_method(const robot::UpdateLogicParams& logic, control::Form form, int estimate_period_ticks,
                         double estimate_period_s) noexcept {
  switch (logic.method) {
    case robot::UpdateMethod::kLimits: return LimitedGains(logic, estimate_period_ticks, estimate_period_s);
    case robot::UpdateMethod::kSmallError:
    case robot::UpdateMethod::kWhiteError: return PredictionError(logic, estimate_period_ticks);
    case robot::UpdateMethod::kDistinctPoles: break;
  }
  return DistinctPoles(logic, form, estimate_period_ticks);
}

}  // namespace farrier::supervisor
