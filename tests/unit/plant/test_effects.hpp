#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "plant/terms/load_effects.hpp"
#include "test_joints.hpp"

namespace farrier::plant::test {

/// An effect by name; parameters in the file's units, those left out by their defaults.
inline ActiveEffect effect_of(std::string_view name, std::initializer_list<double> values,
                              const ActuatorParams& actuator, const LoadParams& load) {
  const Scales scales(actuator, load);
  ActiveEffect effect{find_effect(name), {}};
  for (std::size_t i = 0; i < effect.info().parameters.size(); ++i) {
    effect.values[i] = i < values.size() ? values.begin()[i]
                                         : default_value(effect.info().parameters[i], scales, actuator, load);
  }
  return effect;
}

/// At rest in mid-stroke without any effect; those in the load's parameters are put there.
inline HydraulicJoint joint_with(const ActuatorParams& actuator, const LoadParams& load,
                                 const std::vector<ActiveEffect>& effects,
                                 double tolerance = HydraulicJoint::kDefaultTolerance) {
  const State middle = equilibrium(actuator, load, 0.5 * actuator.stroke, 0.0);
  const LoadParams changed = loads_with_effects({load, load}, actuator, effects).swing;
  return HydraulicJoint::create(actuator, changed, middle, tolerance, effects).value();
}

/// Bit for bit.
inline bool same(const HydraulicJoint& one, const HydraulicJoint& other) {
  const State& a = one.state();
  const State& b = other.state();
  return a.position == b.position && a.velocity == b.velocity && a.pressure_a_Pa == b.pressure_a_Pa &&
         a.pressure_b_Pa == b.pressure_b_Pa && one.load_cell_force() == other.load_cell_force();
}

}  // namespace farrier::plant::test
