#include "control/law/effect_compensation.hpp"

#include <cmath>

namespace farrier::control {
namespace {

using plant::effect_id;

// Bound of the amplification of noise by the force's lead.
constexpr double kMostForceLead = 8.0;
// Share of the period: a rest below half of it is less than the cost of sampling.
constexpr double kLeastRestShare = 0.5;

}  // namespace

EffectCompensation::EffectCompensation(std::span<const plant::ActiveEffect> effects,
                                       const plant::ActuatorParams& actuator,
                                       const CompensationParams& params) noexcept
    : current_max_A_(actuator.valve_current_max_A), valve_(effects, current_max_A_) {
  for (const plant::ActiveEffect& effect : effects) {
    if (is_compensated(effect.id)) {
      take(effect, actuator, params);
    }
  }
  fresh_force_lead_ = force_lead_;
  fresh_velocity_ = velocity_;
}

void EffectCompensation::take(const plant::ActiveEffect& effect, const plant::ActuatorParams& actuator,
                              const CompensationParams& params) noexcept {
  const double value = effect.values[0];
  const double least_rest_s = kLeastRestShare * params.period_s;
  acts_on_valve_ = acts_on_valve_ || effect.info().side == plant::Side::kValveAndOil;
  acts_on_sensors_ = acts_on_sensors_ || effect.info().side != plant::Side::kValveAndOil;
  if (effect.id == effect_id<plant::InputDelay>()) {
    delay_s_ += value;
  } else if (effect.id == effect_id<plant::ValveBias>()) {
    bias_A_ = value;
  } else if (effect.id == effect_id<plant::ValveDynamics>()) {
    spool_ = SpoolLead(value, effect.values[1], current_max_A_, params.period_s);
    delay_s_ += spool_.lag_ticks() * params.period_s;
  } else if (effect.id == effect_id<plant::SupplyDroop>()) {
    supply_ = DroopInverse(value, actuator);
  } else if (effect.id == effect_id<plant::ForceSensorGain>()) {
    force_gain_ = value;
  } else if (effect.id == effect_id<plant::ForceSensorOffset>()) {
    force_offset_ = value;
  } else if (effect.id == effect_id<plant::ForceSensorLag>()) {
    force_lead_ = LagLead(value, kMostForceLead, least_rest_s, params.period_s);
  } else if (effect.id == effect_id<plant::VelocityFilterLag>()) {
    const double smoothed_s = std::max(least_rest_s, params.velocity_noise > 0.0
                                                         ? params.position_noise / params.velocity_noise
                                                         : (params.position_noise > 0.0 ? value : 0.0));
    if (smoothed_s < value) {
      velocity_ = PositionRate(smoothed_s, params.period_s);
    }
  }
}

Measurement EffectCompensation::corrected(const Measurement& read) noexcept {
  if (!acts_on_sensors_) {
    return read;
  }
  // The cell's terms in reverse order: offset, gain, lag.
  const Measurement truth{read.position, velocity_.active() ? velocity_.take(read.position) : read.velocity,
                          force_lead_.take((read.force - force_offset_) / force_gain_)};
  if (!std::isfinite(truth.velocity) || !std::isfinite(truth.force)) {
    force_lead_ = fresh_force_lead_;
    velocity_ = fresh_velocity_;
    return read;
  }
  return truth;
}

double EffectCompensation::current_A(double opening_A, const Measurement& truth) noexcept {
  if (!acts_on_valve_) {
    return opening_A;
  }
  const double wanted_A = valve_.current_A(supply_.opening_A(opening_A, truth));
  return std::clamp(spool_.take(wanted_A) - bias_A_, -current_max_A_, current_max_A_);
}

void EffectCompensation::reset() noexcept {
  force_lead_ = fresh_force_lead_;
  velocity_ = fresh_velocity_;
  spool_.reset();
}

}  // namespace farrier::control
