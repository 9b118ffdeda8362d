#pragma once

// Shared by tests of the compensation of effects: the plant's own terms, in SI.

#include <vector>

#include "plant/nominal.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::control {

using plant::ActiveEffect;
using plant::effect_id;

inline constexpr double kPeriod_s = 1e-3;
inline constexpr double kMost_A = 0.01;
inline const plant::ActuatorParams kActuator = plant::nominal_cylinder();

inline const ActiveEffect kSpool{effect_id<plant::ValveDynamics>(), {300.0, 0.7}};
inline const ActiveEffect kCellLag{effect_id<plant::ForceSensorLag>(), {0.004}};

/// Scales that leave SI values as they are, but for reciprocal ones.
inline plant::Scales unit_scales() {
  plant::ActuatorParams unit;
  unit.area_a = unit.area_b = unit.stroke = unit.valve_gain = unit.valve_current_max_A = unit.supply_pressure_Pa = 1.0;
  return {unit, {}};
}

inline plant::TermSet<double> terms_of(const std::vector<ActiveEffect>& effects) {
  plant::TermSet<double> terms;
  for (const ActiveEffect& effect : effects) {
    add_to(terms, effect, unit_scales(), kPeriod_s);
  }
  return terms;
}

/// Current with which an ideal valve would open the plant's ports as they open at `current_A`.
inline double opening_A(plant::TermSet<double>& terms, double current_A) {
  plant::ValveMoment<double> valve{current_A, 1.0};
  terms.on_valve(valve);
  return valve.flow_factor * valve.opening_A;
}

}  // namespace farrier::control
