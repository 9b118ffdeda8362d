#pragma once

// The joint's equations, cut at the load cell:
//
//   current, motion, supply ──▶ ActuatorEquations ──▶ flows, pressures, force ──▶ LoadEquations ──▶ motion
//
// One integrator advances both halves together.

#include "plant/actuator_equations.hpp"
#include "plant/load_equations.hpp"

namespace farrier::plant {

/// State of the integration. A chamber's compression is its pressure while oil fills it. Below zero the pressure is
/// zero and -compression / beta_e is the share of the chamber that is void, to be refilled before pressure rises again.
struct IntegrationState {
  double position;
  double velocity;
  double compression_a_Pa;
  double compression_b_Pa;
};

/// Inputs held over a step.
struct HeldInput : OpenValve {
  double external_force;  ///< N or Nm
};

/// Right-hand side of the nonlinear joint, Hubacher (2014) (2.30a), (2.30b) in one form, with flow both ways
/// through every orifice, voids, end stops and an external force. Uses no function but sqrt.
class JointEquations {
 public:
  using State = IntegrationState;
  using Input = HeldInput;

  JointEquations(const ActuatorParams& actuator, const LoadParams& load) noexcept
      : actuator_(actuator), load_(load, actuator.piston_mass, actuator.piston_damping) {}

  /// Constants of the load; the state is not touched.
  void set_load(const LoadParams& load) noexcept { load_.set(load); }

  HeldInput hold(double valve_current_A, double external_force) const noexcept {
    return {actuator_.hold(valve_current_A), external_force};
  }

  IntegrationState derivative(const IntegrationState& s, const HeldInput& input) const noexcept {
    const double p_a = pressure_of(s.compression_a_Pa);
    const double p_b = pressure_of(s.compression_b_Pa);
    return balance(s, p_a, p_b, valve_flow(p_a, p_b, input), input.external_force);
  }

  /// The present valve: the held one.
  const HeldInput& valve(const IntegrationState&, const HeldInput& input) const noexcept { return input; }
  /// The valve's flow at these pressures, into the chambers or the lines before them.
  ChamberFeed valve_flow(double p_a, double p_b, const HeldInput& input) const noexcept {
    return actuator_.valve_flow(p_a, p_b, input);
  }

  /// Rates of motion and pressures when the chambers get `feed` and the load `load_force`.
  IntegrationState balance(const IntegrationState& s, double p_a, double p_b, const ChamberFeed& feed,
                           double load_force) const noexcept {
    const CompressionRates rates =
        actuator_.compression_rates(s.position, s.velocity, s.compression_a_Pa, s.compression_b_Pa, p_a, p_b, feed);
    const double acceleration = load_.acceleration(s.position, s.velocity, plant::hydraulic_force(actuator(), p_a, p_b),
                                                   load_force, stop_force(s));
    return {s.velocity, acceleration, rates.a_Pa_s, rates.b_Pa_s};
  }

  /// Volumes of the chambers with their parts of the lines; a quarter of line_volume_m3 at least.
  ChamberVolumes<double> volumes(double position) const noexcept { return actuator_.volumes(position); }
  /// F_h, (2.8).
  double hydraulic_force(const IntegrationState& s) const noexcept {
    return plant::hydraulic_force(actuator(), pressure_of(s.compression_a_Pa), pressure_of(s.compression_b_Pa));
  }
  /// Force of the end stops on the piston.
  double stop_force(const IntegrationState& s) const noexcept { return actuator_.stop_force(s.position, s.velocity); }

  const ActuatorParams& actuator() const noexcept { return actuator_.params(); }
  const LoadParams& load() const noexcept { return load_.params(); }

 private:
  ActuatorEquations actuator_;
  LoadEquations load_;
};

}  // namespace farrier::plant
