// Another load, or another valve and oil, from now on.

#include "plant/fastest_rate.hpp"
#include "plant/hydraulic_joint.hpp"

namespace farrier::plant {

bool HydraulicJoint::set_load(const LoadParams& given) noexcept {
  LoadParams load = given;
  load.friction = guide_.value_or(given.friction);
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
  has_effects_ = effects_.active();
  find_lean();
  hold(command_);
  differentiate();
  return true;
}

}  // namespace farrier::plant
