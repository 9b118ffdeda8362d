#include "control/law/feedback_linearisation.hpp"

#include <algorithm>
#include <cmath>

#include "plant/load_pressure.hpp"
#include "plant/oil.hpp"

namespace farrier::control {
namespace {

double cube(double x) noexcept { return x * x * x; }

/// A_p p_l = F_s + d_p v.
double load_pressure_Pa(const plant::ActuatorParams& actuator, const Measurement& measurement) noexcept {
  return (measurement.force + actuator.piston_damping * measurement.velocity) / actuator.area_a;
}

}  // namespace

FeedbackLinearisation::FeedbackLinearisation(const plant::ActuatorParams& actuator,
                                             const FeedbackLinearisationGains& gains, double operating_position,
                                             double period_s) noexcept
    : actuator_(actuator),
      gains_(gains),
      operating_position_(operating_position),
      period_s_(period_s),
      alpha_(actuator.area_b / actuator.area_a),
      valve_gain_(actuator.valve_gain / std::sqrt(1.0 + cube(alpha_))) {}

double FeedbackLinearisation::stiffness_per_area(double position) const noexcept {
  const double inside = std::clamp(operating_position_ + position, 0.0, actuator_.stroke);
  const auto [v_a, v_b] = plant::chamber_volumes(actuator_, inside);
  return actuator_.area_a * actuator_.bulk_modulus_Pa * (1.0 / v_a + alpha_ * alpha_ / v_b);  // (3.32)
}

bool FeedbackLinearisation::set_physics(const plant::JointPhysics& physics) noexcept {
  if (plant::first_unphysical(physics) != nullptr) {
    return false;
  }
  valve_gain_ = physics.valve_gain / std::sqrt(1.0 + cube(alpha_));
  leakage_ = physics.leakage;
  actuator_.bulk_modulus_Pa = physics.bulk_modulus;
  return true;
}

// (3.23): p_s - p_l - alpha p_t for u > 0, alpha p_s + p_l - p_t for u < 0
double FeedbackLinearisation::drop_root(double current_sign, const Measurement& measurement) const noexcept {
  const double load_Pa = load_pressure_Pa(actuator_, measurement);
  const double drop_Pa = current_sign > 0.0
                             ? actuator_.supply_pressure_Pa - load_Pa - alpha_ * actuator_.return_pressure_Pa
                             : alpha_ * actuator_.supply_pressure_Pa + load_Pa - actuator_.return_pressure_Pa;
  return std::sqrt(std::max(drop_Pa, actuator_.laminar_pressure_Pa));
}

double FeedbackLinearisation::leakage_flow(double current_sign, const Measurement& measurement) const noexcept {
  if (!(leakage_ > 0.0)) {
    return 0.0;
  }
  return leakage_ *
         plant::leakage_pressure_Pa(
             actuator_, {.position = std::clamp(operating_position_ + measurement.position, 0.0, actuator_.stroke),
                         .load_pressure_Pa = load_pressure_Pa(actuator_, measurement),
                         .valve_sign = current_sign > 0.0 ? 1.0 : -1.0});
}

double FeedbackLinearisation::current_for(double force_rate, const Measurement& measurement) const noexcept {
  const double k = stiffness_per_area(measurement.position);
  const double compensation = gains_.velocity_compensation * actuator_.area_a * k * measurement.velocity;
  const double moving = force_rate + compensation;
  // The pressures that leak are those of the valve's side, which a leakage alone may decide.
  double wanted = moving + k * leakage_flow(moving, measurement);
  wanted = moving + k * leakage_flow(wanted, measurement);
  return wanted / (valve_gain_ * k * drop_root(wanted, measurement));
}

// d = p + w F with p' = -w (d + F'_law): the derivative of the force is not taken.
void FeedbackLinearisation::observe(double force) noexcept {
  if (!(gains_.observer_1_s > 0.0) || !std::isfinite(force)) {
    return;
  }
  if (has_run_) {
    observer_state_ -= period_s_ * gains_.observer_1_s * (disturbance_ + law_rate_);
  } else {
    observer_state_ = -gains_.observer_1_s * force;
  }
  disturbance_ = observer_state_ + gains_.observer_1_s * force;
}

// A derivative over a time constant T is (v - s) / T, s the velocity smoothed by T: with T twice the lead the lead
// multiplies noise by 1.5.
Measurement FeedbackLinearisation::led(const Measurement& measurement) noexcept {
  if (!(gains_.velocity_lead_s > 0.0) || !std::isfinite(measurement.velocity)) {
    return measurement;
  }
  if (!has_run_) {
    slow_velocity_ = measurement.velocity;
  }
  slow_velocity_ += period_s_ / (2.0 * gains_.velocity_lead_s + period_s_) * (measurement.velocity - slow_velocity_);
  Measurement later = measurement;
  later.velocity += 0.5 * (measurement.velocity - slow_velocity_);
  return later;
}

FeedbackLinearisation::Output FeedbackLinearisation::step(double force_reference, const Measurement& read) noexcept {
  const Measurement measurement = led(read);
  observe(measurement.force);
  const double error = force_reference - measurement.force;
  const double proportional = gains_.force_1_s * error;
  const double k = stiffness_per_area(measurement.position);
  const double standing = proportional + gains_.velocity_compensation * actuator_.area_a * k * measurement.velocity;
  const double integral = !has_run_ && gains_.integral_1_s2 > 0.0 ? -standing : integral_;
  const double wanted_A = current_for(proportional + integral - disturbance_, measurement);
  if (!std::isfinite(standing) || !std::isfinite(wanted_A)) {
    return {0.0, false};
  }
  integral_ = integral;
  has_run_ = true;
  const double limit_A = actuator_.valve_current_max_A;
  const double current_A = std::clamp(wanted_A, -limit_A, limit_A);
  const bool saturated = current_A != wanted_A;
  if (!saturated || error * wanted_A < 0.0) {
    integral_ += gains_.integral_1_s2 * error * period_s_;
  }
  if (gains_.observer_1_s > 0.0) {
    law_rate_ = k * (valve_gain_ * drop_root(current_A, measurement) * current_A -
                     actuator_.area_a * measurement.velocity - leakage_flow(current_A, measurement));
  }
  // No more than the open valve can do with all of both drops: a wild measurement leaves nothing behind for long.
  const double most = valve_gain_ * k * limit_A * std::sqrt((1.0 + alpha_) * actuator_.supply_pressure_Pa);
  integral_ = std::clamp(integral_, -most, most);
  return {current_A, saturated};
}

void FeedbackLinearisation::reset() noexcept {
  integral_ = 0.0;
  disturbance_ = 0.0;
  has_run_ = false;
}

}  // namespace farrier::control
