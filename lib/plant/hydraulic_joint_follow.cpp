// The half of a hydraulic joint left of the load cell, moved by a mechanism; and changes of load, valve and oil.

#include <cmath>
#include <limits>

#include "plant/fastest_rate.hpp"
#include "plant/hydraulic_joint.hpp"

namespace farrier::plant {

// A load of infinite mass keeps the velocity that it is given.
StepReport HydraulicJoint::follow(double valve_current_A, double supply_pressure_Pa, const Motion& end, double period_s,
                                  OilAccount& account) noexcept {
  StepReport report;
  if (!(period_s > 0.0 && period_s <= kLongestPeriod_s) || !std::isfinite(end.position) ||
      !std::isfinite(end.velocity)) {
    report.input_refused = true;
    return report;
  }
  CommandInput input = admit(valve_current_A, 0.0, report);
  const bool supplied = supply_pressure_Pa >= 0.0 && std::isfinite(supply_pressure_Pa);
  report.input_refused |= !supplied;
  input.supply_fall_Pa = supplied ? actuator().supply_pressure_Pa - supply_pressure_Pa : 0.0;
  equations_.set_load({.mass = std::numeric_limits<double>::infinity()});
  effects_.change<FlexiblePart>().set({}, 0.0);
  const double velocity_before = state_.velocity;
  integrated_.velocity = (end.position - integrated_.position) / period_s;
  hold(at_spool(input));
  differentiate();
  const double relative_error =
      delay_.active() ? advance_delayed(period_s, report, &account) : advance(period_s, report, &account);
  report_errors(relative_error, report);
  integrated_.position = end.position;
  integrated_.velocity = end.velocity;
  derivative_.velocity = (end.velocity - velocity_before) / period_s;
  publish_state();
  return report;
}

double HydraulicJoint::effects_load_force() const noexcept {
  return lean_ ? 0.0 : with_effects().effects_load_force(integrated_, command_);
}

double HydraulicJoint::mechanism_force() const noexcept {
  const double given = load_cell_force() + actuator().piston_mass * acceleration();
  return has_effects_ ? given + effects_load_force() : given;
}

double HydraulicJoint::stored_J() const noexcept {
  const auto [v_a, v_b] = equations_.volumes(integrated_.position);
  const double p_a = state_.pressure_a_Pa;
  const double p_b = state_.pressure_b_Pa;
  return (v_a * p_a * p_a + v_b * p_b * p_b) / (2.0 * actuator().bulk_modulus_Pa);
}

bool HydraulicJoint::set_load(const LoadParams& given) noexcept {
  LoadParams load = given;
  load.friction = guide_.value_or(given.friction);
  load.flexible = part_.value_or(given.flexible);
  if (!is_physical(load, actuator().piston_mass)) {
    return false;
  }
  Effects effects = effects_;
  const Effects::X carried = effects.set_load(load, integrated_.x);
  if (!stable_substep(fastest_rate(actuator(), load, effects))) {
    return false;
  }
  equations_.set_load(load);
  effects_ = effects;
  integrated_.x = carried;
  has_effects_ = effects_.active();
  find_lean();
  hold(command_);
  differentiate();
  return true;
}

bool HydraulicJoint::set_actuator(const ActuatorParams& nominal, std::span<const ActiveEffect> given) noexcept {
  if (!validate(given).ok()) {
    return false;
  }
  const ActuatorParams actuator = plant::with_effects(nominal, given);
  if (!validate(actuator).ok()) {
    return false;
  }
  const Effects effects(actuator, load(), given, tolerance_);
  if (!stable_substep(fastest_rate(actuator, load(), effects))) {
    return false;
  }
  const LoadParams load = this->load();
  actuator_ = actuator;
  equations_ = JointEquations(without_lines(actuator), load);
  effects_ = effects;
  hysteresis_ = hysteresis_of(given, Scales(actuator, load));
  if (hysteresis_) {
    hysteresis_->put(command_.command_A);
  }
  has_effects_ = effects_.active();
  find_lean();
  hold(command_);
  differentiate();
  return true;
}

}  // namespace farrier::plant
