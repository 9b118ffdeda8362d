#include "plant/fastest_rate.hpp"

#include <algorithm>
#include <cmath>

#include "plant/load_equations.hpp"

namespace farrier::plant {
namespace {

bool positive(double value) noexcept { return std::isfinite(value) && value > 0.0; }
bool not_negative(double value) noexcept { return std::isfinite(value) && value >= 0.0; }

/// Without effects: a chamber filling through the laminar full-open valve, and the piston on its stop with both oil
/// columns, springs and dampers acting.
double of_equations(const ActuatorParams& actuator, const LoadParams& load) noexcept {
  const double oil = actuator.bulk_modulus_Pa / actuator.line_volume_m3;
  const double filling =
      oil * actuator.valve_gain * actuator.valve_current_max_A / std::sqrt(actuator.laminar_pressure_Pa);
  const double mass = rigid_mass(load) + actuator.piston_mass;
  // Slope of an engaging stop: k (s + s' depth) <= 1.7 k, and d v s' <= 1.5 d v / ramp at the valve's full speed.
  const double stop =
      1.7 * actuator.stop_stiffness + 1500.0 * actuator.stop_damping * velocity_scale(actuator) / actuator.stroke;
  const double stiffness =
      load.stiffness + stop + oil * (actuator.area_a * actuator.area_a + actuator.area_b * actuator.area_b);
  const double damping = load.damping + actuator.piston_damping + actuator.stop_damping;
  return std::max(filling, damping / mass + std::sqrt(stiffness / mass));
}

}  // namespace

ActuatorParams without_lines(ActuatorParams actuator) noexcept {
  actuator.line_volume_m3 -= valve_side_volume_m3(actuator.line);
  return actuator;
}

double fastest_rate(const ActuatorParams& actuator, const LoadParams& load, const Effects& effects) noexcept {
  return std::max(of_equations(without_lines(actuator), load),
                  effects.fastest_rate(rigid_mass(load) + actuator.piston_mass));
}

bool is_physical(const LoadParams& load, double piston_mass) noexcept {
  const FrictionParams& dry = load.friction;
  const bool guided = not_negative(dry.coulomb) && not_negative(dry.breakaway) && dry.breakaway >= dry.coulomb &&
                      (dry.coulomb > 0.0 || dry.breakaway == 0.0) && positive(dry.stribeck_velocity) &&
                      positive(dry.presliding);
  const FlexibleParams& part = load.flexible;
  const bool hung = not_negative(part.share) && part.share < 1.0 && positive(part.natural_frequency_rad_s) &&
                    not_negative(part.damping);
  return guided && hung && not_negative(load.mass) && not_negative(load.damping) && not_negative(load.stiffness) &&
         std::isfinite(load.equilibrium_position) && rigid_mass(load) + piston_mass > 0.0;
}

}  // namespace farrier::plant
