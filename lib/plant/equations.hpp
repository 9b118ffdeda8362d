#pragma once

#include <cmath>

#include "plant/actuator.hpp"
#include "plant/end_stop.hpp"

namespace farrier::plant {

/// (drop^2 + delta^2)^(1/4), sqrt(Pa): the divisor of orifice_root.
inline double orifice_divisor(double drop_Pa, double laminar_pressure_Pa) noexcept {
  return std::sqrt(std::sqrt(drop_Pa * drop_Pa + laminar_pressure_Pa * laminar_pressure_Pa));
}

/// Signed root of a pressure drop, sqrt(Pa): drop / (drop^2 + delta^2)^(1/4). Odd, smooth, and sqrt(drop) for
/// drop >> delta; near zero it is the laminar flow drop / sqrt(delta). At drop = 10 delta it is 0.25 % below the
/// root. (Borutzky, Barnard and Thoma 2002 motivate the transition; this closed form is Simscape's orifice.)
inline double orifice_root(double drop_Pa, double laminar_pressure_Pa) noexcept {
  return drop_Pa / orifice_divisor(drop_Pa, laminar_pressure_Pa);
}

/// State of the integration. A chamber's compression is its pressure while oil fills it. Below zero the pressure is
/// zero and -compression / beta_e is the share of the chamber that is void, to be refilled before pressure rises again.
struct IntegrationState {
  double position;
  double velocity;
  double compression_a_Pa;
  double compression_b_Pa;
};

/// Inputs held over a step.
struct HeldInput {
  double flow_gain;       ///< K_v |u|, m^3/s/sqrt(Pa)
  double port_a_Pa;       ///< pressure the valve connects to chamber a
  double port_b_Pa;       ///< and to chamber b
  double external_force;  ///< N or Nm
};

struct ChamberVolumes {
  double a_m3, b_m3;
};

/// Pressure of a chamber, Pa: none where it holds a void.
inline double pressure_of(double compression_Pa) noexcept { return compression_Pa > 0.0 ? compression_Pa : 0.0; }

/// Right-hand side of the nonlinear joint, Hubacher (2014) (2.30a), (2.30b) in one form, with flow both ways
/// through every orifice, voids, end stops and an external force. Uses no function but sqrt.
class JointEquations {
 public:
  using State = IntegrationState;
  using Input = HeldInput;

  JointEquations(const ActuatorParams& actuator, const LoadParams& load) noexcept;

  /// Constants of the load; the state is not touched.
  void set_load(const LoadParams& load) noexcept;

  HeldInput hold(double valve_current_A, double external_force) const noexcept;
  IntegrationState derivative(const IntegrationState& s, const HeldInput& input) const noexcept;

  /// The valve's flow at these pressures, into the chambers or the lines before them.
  ChamberFeed valve_flow(double p_a, double p_b, const HeldInput& input) const noexcept;
  /// Rates of motion and pressures when the chambers get `feed` and the load `load_force`.
  IntegrationState balance(const IntegrationState& s, double p_a, double p_b, const ChamberFeed& feed,
                           double load_force) const noexcept;

  /// Volumes of the chambers with their parts of the lines; a quarter of line_volume_m3 at least.
  ChamberVolumes volumes(double position) const noexcept;
  /// F_h = A_p (p_a - alpha p_b), (2.8).
  double hydraulic_force(const IntegrationState& s) const noexcept;
  /// Force of the end stops on the piston: only pushes inward, never returns more than it took.
  double stop_force(const IntegrationState& s) const noexcept;

  const ActuatorParams& actuator() const noexcept { return actuator_; }
  const LoadParams& load() const noexcept { return load_; }

 private:
  double stop_push(double depth, double approach_speed) const noexcept;

  ActuatorParams actuator_;
  LoadParams load_;
  double inverse_mass_ = 0.0;
  double total_damping_ = 0.0;
  double inverse_bulk_modulus_;
  double smallest_volume_m3_;
  double inverse_stop_ramp_;
};

inline JointEquations::JointEquations(const ActuatorParams& actuator, const LoadParams& load) noexcept
    : actuator_(actuator),
      inverse_bulk_modulus_(1.0 / actuator.bulk_modulus_Pa),
      smallest_volume_m3_(0.25 * actuator.line_volume_m3),
      inverse_stop_ramp_(1000.0 / actuator.stroke) {
  set_load(load);
}

inline void JointEquations::set_load(const LoadParams& load) noexcept {
  load_ = load;
  inverse_mass_ = 1.0 / (load.mass + actuator_.piston_mass);       // (2.25)
  total_damping_ = load.damping + actuator_.piston_damping;        // (2.26)
}

inline HeldInput JointEquations::hold(double valve_current_A, double external_force) const noexcept {
  const bool extends = valve_current_A > 0.0;
  return {actuator_.valve_gain * std::abs(valve_current_A),
          extends ? actuator_.supply_pressure_Pa : actuator_.return_pressure_Pa,
          extends ? actuator_.return_pressure_Pa : actuator_.supply_pressure_Pa, external_force};
}

inline double JointEquations::stop_push(double depth, double approach_speed) const noexcept {
  // engaged over the first thousandth of the stroke
  return plant::stop_push(depth, approach_speed, depth * inverse_stop_ramp_, actuator_.stop_stiffness,
                          actuator_.stop_damping);
}

inline double JointEquations::stop_force(const IntegrationState& s) const noexcept {
  if (s.position < 0.0) {
    return stop_push(-s.position, -s.velocity);
  }
  const double beyond = s.position - actuator_.stroke;
  return beyond > 0.0 ? -stop_push(beyond, s.velocity) : 0.0;
}

inline double JointEquations::hydraulic_force(const IntegrationState& s) const noexcept {
  return actuator_.area_a * pressure_of(s.compression_a_Pa) - actuator_.area_b * pressure_of(s.compression_b_Pa);
}

inline ChamberVolumes JointEquations::volumes(double position) const noexcept {
  // (2.12) V_a = V_pl + A_p x, (2.13) V_b = V_pl + (L_c - x) alpha A_p
  const double v_a = actuator_.line_volume_m3 + actuator_.area_a * position;
  const double v_b = actuator_.line_volume_m3 + actuator_.area_b * (actuator_.stroke - position);
  return {v_a > smallest_volume_m3_ ? v_a : smallest_volume_m3_, v_b > smallest_volume_m3_ ? v_b : smallest_volume_m3_};
}

inline ChamberFeed JointEquations::valve_flow(double p_a, double p_b, const HeldInput& input) const noexcept {
  // (2.14), (2.15): both chambers' flows counted inward, q = K_v |u| drop / root(drop); the port pressures carry
  // the sign of u.
  const double drop_a = input.port_a_Pa - p_a;
  const double drop_b = input.port_b_Pa - p_b;
  return {input.flow_gain * drop_a, orifice_divisor(drop_a, actuator_.laminar_pressure_Pa),
          input.flow_gain * drop_b, orifice_divisor(drop_b, actuator_.laminar_pressure_Pa)};
}

inline IntegrationState JointEquations::balance(const IntegrationState& s, double p_a, double p_b,
                                                const ChamberFeed& feed, double load_force) const noexcept {
  const ActuatorParams& act = actuator_;
  const auto [v_a, v_b] = volumes(s.position);

  // (2.10), (2.11): c' = beta_e / V (q - V'). With a void W = -c V / beta_e the same balance W' = V' - q
  // asks for c' = beta_e / V (q - V' (1 + c / beta_e)).
  const double filled_a = 1.0 + (s.compression_a_Pa - p_a) * inverse_bulk_modulus_;
  const double filled_b = 1.0 + (s.compression_b_Pa - p_b) * inverse_bulk_modulus_;
  const double growth_a = act.area_a * s.velocity * filled_a;
  const double growth_b = -act.area_b * s.velocity * filled_b;

  // (2.24) (m_l + m_p) a = A_p (p_a - alpha p_b) - (d_l + d_p) v - C (x - x_eq) + F_ext + F_stop
  const double force = act.area_a * p_a - act.area_b * p_b - total_damping_ * s.velocity -
                       load_.stiffness * (s.position - load_.equilibrium_position) + load_force + stop_force(s);
  return {s.velocity, force * inverse_mass_,
          act.bulk_modulus_Pa * (feed.flow_a - growth_a * feed.root_a) / (v_a * feed.root_a),
          act.bulk_modulus_Pa * (feed.flow_b - growth_b * feed.root_b) / (v_b * feed.root_b)};
}

inline IntegrationState JointEquations::derivative(const IntegrationState& s, const HeldInput& input) const noexcept {
  const double p_a = pressure_of(s.compression_a_Pa);
  const double p_b = pressure_of(s.compression_b_Pa);
  return balance(s, p_a, p_b, valve_flow(p_a, p_b, input), input.external_force);
}

}  // namespace farrier::plant
