#include "plant/actuator.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "plant/refusals.hpp"

namespace farrier::plant {
namespace {

/// All refusals of a subject and its parts in one.
Result<Done> together(std::initializer_list<Result<Done>> verdicts) {
  std::string refused;
  for (const Result<Done>& verdict : verdicts) {
    if (!verdict.ok()) {
      refused += (refused.empty() ? "" : "; ") + verdict.error().message;
    }
  }
  return refused.empty() ? Result<Done>(Done{}) : Result<Done>(Error{refused});
}

}  // namespace

Result<Done> validate(const ActuatorParams& actuator) {
  Refusals refusals("actuator");
  refusals.positive("area_a", actuator.area_a);
  refusals.positive("area_b", actuator.area_b);
  refusals.positive("stroke", actuator.stroke);
  refusals.positive("line_volume_m3", actuator.line_volume_m3);
  refusals.positive("bulk_modulus_Pa", actuator.bulk_modulus_Pa);
  refusals.positive("valve_gain", actuator.valve_gain);
  refusals.positive("valve_current_max_A", actuator.valve_current_max_A);
  refusals.not_negative("return_pressure_Pa", actuator.return_pressure_Pa);
  refusals.require(actuator.supply_pressure_Pa > actuator.return_pressure_Pa, "supply_pressure_Pa",
                   actuator.supply_pressure_Pa,
                   "above return_pressure_Pa, " + number_text(actuator.return_pressure_Pa));
  refusals.not_negative("piston_mass", actuator.piston_mass);
  refusals.not_negative("piston_damping", actuator.piston_damping);
  const double full_push = actuator.supply_pressure_Pa * std::max(actuator.area_a, actuator.area_b);
  refusals.require(actuator.stop_stiffness * actuator.stroke >= 100.0 * full_push, "stop_stiffness",
                   actuator.stop_stiffness,
                   "at least " + number_text(100.0 * full_push / actuator.stroke) +
                       " (stops.stiffness_N_m of the cylinder), so that the full supply presses in 1 % of the stroke");
  refusals.not_negative("stop_damping", actuator.stop_damping);
  refusals.positive("laminar_pressure_Pa", actuator.laminar_pressure_Pa);
  refusals.require(actuator.valve_deadband_A >= 0.0 && actuator.valve_deadband_A < actuator.valve_current_max_A,
                   "valve_deadband_A", actuator.valve_deadband_A,
                   "at least 0 and below valve_current_max_A, " + number_text(actuator.valve_current_max_A));
  return together({refusals.verdict(), validate(actuator.spool), validate(actuator.line, actuator.line_volume_m3)});
}

Result<Done> validate(const LoadParams& load) {
  Refusals refusals("load");
  refusals.not_negative("mass", load.mass);
  refusals.not_negative("damping", load.damping);
  refusals.not_negative("stiffness", load.stiffness);
  refusals.require(true, "equilibrium_position", load.equilibrium_position, "finite");
  return together({refusals.verdict(), validate(load.friction), validate(load.flexible)});
}

Result<Done> validate(const ActuatorParams& actuator, const State& state) {
  Refusals refusals("initial state");
  refusals.require(state.position >= 0.0 && state.position <= actuator.stroke, "position", state.position,
                   "within [0, stroke]");
  refusals.require(true, "velocity", state.velocity, "finite");
  refusals.not_negative("pressure_a_Pa", state.pressure_a_Pa);
  refusals.not_negative("pressure_b_Pa", state.pressure_b_Pa);
  return refusals.verdict();
}

double velocity_scale(const ActuatorParams& actuator) noexcept {
  return actuator.valve_gain * actuator.valve_current_max_A * std::sqrt(actuator.supply_pressure_Pa) / actuator.area_a;
}

State equilibrium(const ActuatorParams& actuator, const LoadParams& load, double position, double external_force) {
  const double alpha = actuator.area_b / actuator.area_a;
  const double alpha2 = alpha * alpha;
  const double mean_port = 0.5 * (actuator.supply_pressure_Pa + actuator.return_pressure_Pa);
  const double p_t = actuator.return_pressure_Pa;

  const double spring = load.stiffness * (position - load.equilibrium_position);
  const double p_l = (spring - external_force) / actuator.area_a;
  // Mean of (3.19) over u > 0 and u < 0: p_b = ((1 + alpha^2) (p_s + p_t) / 2 - alpha^2 p_l) / (1 + alpha^3)
  const double p_b_mean = ((1.0 + alpha2) * mean_port - alpha2 * p_l) / (1.0 + alpha2 * alpha);
  const double p_b = std::max({p_b_mean, p_t, (p_t - p_l) / alpha});
  return {position, 0.0, p_l + alpha * p_b, p_b};
}

}  // namespace farrier::plant
