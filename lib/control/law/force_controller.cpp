#include "control/law/force_controller.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::control {
namespace {

bool is_finite(const Measurement& m) noexcept {
  return std::isfinite(m.position) && std::isfinite(m.velocity) && std::isfinite(m.force);
}

bool is_usable(const Gains& g) noexcept {
  const Normalisation& n = g.normalisation;
  const double sum = g.position + g.velocity + g.force + g.feed_forward + g.delay[0] + g.delay[1];
  const double integral = g.integral * g.integral_factor;
  return std::isfinite(sum) && std::isfinite(integral) && integral != 0.0 && n.position > 0.0 && n.velocity > 0.0 &&
         n.force > 0.0 && n.current_A > 0.0 && std::isfinite(n.current_A);
}

double total(const ForceController::Output& o) noexcept {
  return o.position_part_A + o.velocity_part_A + o.force_part_A + o.integral_part_A + o.feed_forward_part_A +
         o.delay_part_A;
}

}  // namespace

ForceController::Output ForceController::contributions(const Gains& g, double force_reference,
                                                       const Measurement& m) const noexcept {
  const Normalisation& n = g.normalisation;
  Output output{};
  output.position_part_A = n.current_A * g.position * (0.0 - m.position / n.position);
  output.velocity_part_A = n.current_A * g.velocity * (0.0 - m.velocity / n.velocity);
  output.force_part_A = n.current_A * g.force * (force_reference - m.force) / n.force;
  output.integral_part_A = n.current_A * g.integral_factor * g.integral * sum_;
  output.feed_forward_part_A = n.current_A * g.feed_forward * force_reference / n.force;
  output.delay_part_A = -(g.delay[0] * past_currents_A_[0] + g.delay[1] * past_currents_A_[1]);
  return output;
}

void ForceController::remember(double valve_current_A) noexcept {
  past_currents_A_[1] = past_currents_A_[0];
  past_currents_A_[0] = valve_current_A;
}

bool ForceController::set_gains(const Gains& gains, const Measurement& now, double force_reference) noexcept {
  if (!is_usable(gains) || !is_finite(now) || !std::isfinite(force_reference)) {
    return false;
  }
  if (has_run_) {
    const Output output = contributions(gains, force_reference, now);
    const double others = total(output) - output.integral_part_A;
    const double per_sum = gains.normalisation.current_A * gains.integral_factor * gains.integral;
    const double sum = (command_A_ - others) / per_sum;
    if (!std::isfinite(sum)) {
      return false;
    }
    sum_ = sum;
  }
  gains_ = gains;
  has_gains_ = true;
  return true;
}

ForceController::Output ForceController::step(double force_reference, const Measurement& measurement,
                                               double probe_A) noexcept {
  command_A_ = 0.0;
  if (!has_gains_ || !is_finite(measurement) || !std::isfinite(force_reference)) {
    remember(0.0);
    return {};
  }
  Output output = contributions(gains_, force_reference, measurement);
  const double command = total(output);
  const double wanted = command + probe_A;
  if (!std::isfinite(wanted)) {
    remember(0.0);
    return {};
  }
  const double limit = gains_.normalisation.current_A;
  command_A_ = std::clamp(command, -limit, limit);
  output.valve_current_A = std::clamp(wanted, -limit, limit);
  output.saturated = output.valve_current_A != wanted;
  // xi[k+1] = xi[k] + (r - F), unless that winds up
  const double error = (force_reference - measurement.force) / gains_.normalisation.force;
  const double push = error * gains_.integral * gains_.integral_factor;
  if (!output.saturated || push * wanted < 0.0) {
    sum_ += error;
  }
  remember(output.valve_current_A);
  has_run_ = true;
  return output;
}

void ForceController::reset() noexcept {
  sum_ = 0.0;
  past_currents_A_ = {};
  command_A_ = 0.0;
  has_run_ = false;
}

}  // namespace farrier::control
