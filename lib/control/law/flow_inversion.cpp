#include "control/law/flow_inversion.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::control {
namespace {

constexpr int kMaxSecants = 4;
constexpr double kFirstShare = 0.1;    // of the full current: where the first secant ends
constexpr double kEnoughShare = 1e-6;  // of the full current: steps below this change nothing

/// Stands for physics until there is one.
plant::JointPhysics unit_physics(const plant::ActuatorParams& actuator) noexcept {
  return plant::nominal_physics(actuator, {.mass = 1.0});
}

}  // namespace

FlowInversion::FlowInversion(const plant::ActuatorParams& actuator, const FlowInversionGains& gains,
                             double operating_position, double slack_position, double period_s,
                             int delay_ticks) noexcept
    : actuator_(actuator),
      gains_(gains),
      operating_position_(operating_position),
      slack_position_(slack_position),
      period_s_(period_s),
      delay_ticks_(static_cast<std::size_t>(std::clamp(delay_ticks, 0, kMaxDelayTicks))),
      most_force_(actuator.supply_pressure_Pa * std::max(actuator.area_a, actuator.area_b)),
      model_(actuator, unit_physics(actuator), slack_position, period_s) {}

bool FlowInversion::set_physics(const plant::JointPhysics& physics) noexcept {
  if (plant::first_unphysical(physics) != nullptr) {
    return false;
  }
  const double force = model_.load_cell_force(state_, disturbance_);
  model_ = FlowModel(actuator_, physics, slack_position_, period_s_);
  if (has_run_) {
    disturbance_.load_force += bias_force_ - physics.bias_force;
    model_.set_force(state_, force, disturbance_);
  }
  bias_force_ = physics.bias_force;
  has_physics_ = true;
  return true;
}

void FlowInversion::begin(const Measurement& m) noexcept {
  // Chamber pressures: the mean of (3.19) and (3.20) over both signs of the valve, under the force measured.
  state_ = plant::equilibrium(actuator_, {.mass = 1.0}, operating_position_ + m.position,
                              -std::clamp(m.force, -most_force_, most_force_));
  state_.velocity = m.velocity;
  disturbance_ = {};
  model_.set_force(state_, m.force, disturbance_);
  sent_A_ = {};
  has_run_ = true;
}

void FlowInversion::correct(const Measurement& m) noexcept {
  const double predicted = model_.load_cell_force(state_, disturbance_);
  const double force_beyond = m.force - predicted;
  const double velocity_beyond = m.velocity - state_.velocity;
  state_.position = operating_position_ + m.position;
  state_.velocity += gains_.velocity_share * velocity_beyond;
  // No more than moves the whole of the force range in a tick, and no more than that range.
  const double most_rate = most_force_ / period_s_;
  disturbance_.force_rate_per_s =
      std::clamp(disturbance_.force_rate_per_s + gains_.flow_share * force_beyond / period_s_, -most_rate, most_rate);
  disturbance_.load_force = std::clamp(
      disturbance_.load_force + gains_.load_share * model_.moving_mass() * velocity_beyond / period_s_, -most_force_,
      most_force_);
  model_.set_force(state_, predicted + gains_.force_share * force_beyond, disturbance_);
}

double FlowInversion::current_for(const plant::State& state, const Line& wanted) const noexcept {
  const auto beyond = [&](double current_A) {
    const plant::State end = model_.advance(state, current_A, disturbance_);
    return model_.load_cell_force(end, disturbance_) - wanted.at(end);
  };
  // The force at the end, and what moves the wanted one towards it, grows with the current, almost in proportion on
  // either side of null: secants from there.
  const double limit_A = actuator_.valve_current_max_A;
  double before_A = 0.0;
  double before = beyond(before_A);
  const double sign = before < 0.0 ? 1.0 : -1.0;
  double current_A = sign * kFirstShare * limit_A;
  for (int i = 0; i < kMaxSecants; ++i) {
    const double reached = beyond(current_A);
    const double slope = (reached - before) / (current_A - before_A);
    if (!(slope > 0.0)) {
      break;  // both ends of a range in which the chambers hold no more: what is asked for is beyond it
    }
    before_A = current_A;
    before = reached;
    // Stays on the side on which it must lie.
    current_A = sign * std::clamp(sign * (current_A - reached / slope), 0.0, 2.0 * limit_A);
    if (!(std::abs(current_A - before_A) > kEnoughShare * limit_A) || std::abs(before_A) > limit_A) {
      break;
    }
  }
  return current_A;
}

FlowInversion::Output FlowInversion::send(double wanted_A) noexcept {
  const double limit_A = actuator_.valve_current_max_A;
  const double current_A = std::clamp(wanted_A, -limit_A, limit_A);
  for (std::size_t i = sent_A_.size() - 1; i > 0; --i) {
    sent_A_[i] = sent_A_[i - 1];
  }
  sent_A_[0] = current_A;
  return {current_A, current_A != wanted_A};
}

FlowInversion::Output FlowInversion::step(const ForceReference& reference, const Measurement& measurement,
                                          double probe_A) noexcept {
  const bool finite = std::isfinite(reference.force) && std::isfinite(reference.stiffness) &&
                      std::isfinite(reference.damping) && std::isfinite(probe_A) &&
                      std::isfinite(measurement.position) &&
                      std::isfinite(measurement.velocity) && std::isfinite(measurement.force);
  if (!has_physics_ || (!finite && !has_run_)) {
    return {0.0, false};
  }
  if (!has_run_) {
    begin(measurement);
  } else {
    state_ = model_.advance(state_, sent_A_[delay_ticks_], disturbance_);
  }
  if (!finite) {
    return send(0.0);
  }
  correct(measurement);
  plant::State acting = state_;  // when what is sent now begins to act
  for (std::size_t i = delay_ticks_; i > 0; --i) {
    acting = model_.advance(acting, sent_A_[i - 1], disturbance_);
  }
  const Line now{reference.force, reference.stiffness, reference.damping, state_.position, measurement.velocity};
  // By how much the force wanted at the place and velocity of now has changed since the last tick.
  const plant::State measured{.position = now.position, .velocity = now.velocity};
  const double change = has_last_ ? gains_.reference_share * (now.force - last_.at(measured)) : 0.0;
  Line wanted = now;
  wanted.force += static_cast<double>(delay_ticks_) * change;
  const double error = wanted.at(acting) - model_.load_cell_force(acting, disturbance_);
  wanted.force += change - (1.0 - gains_.error_share) * error;
  const double wanted_A = current_for(acting, wanted) + probe_A;
  last_ = now;
  has_last_ = true;
  if (!std::isfinite(wanted_A)) {
    reset();
    return {0.0, false};
  }
  return send(wanted_A);
}

void FlowInversion::reset() noexcept {
  has_run_ = false;
  has_last_ = false;
  state_ = {};
  disturbance_ = {};
  sent_A_ = {};
}

}  // namespace farrier::control
