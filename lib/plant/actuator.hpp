#pragma once

#include "core/result.hpp"
#include "plant/effects/flexible_part.hpp"
#include "plant/effects/friction.hpp"
#include "plant/effects/lines.hpp"
#include "plant/effects/spool.hpp"

namespace farrier::plant {

/// Valve and actuator of one joint. The same equations serve an asymmetric cylinder (lengths in m, forces in N) and a
/// rotary vane motor, which is the symmetric case (angles in rad, torques in Nm). Below, "position" is m (cylinder) or
/// rad (rotary), "force" N or Nm. All values finite; symbols of Hubacher (2014), Table A.1.
struct ActuatorParams {
  double area_a = 0.0;               ///< A_p, m^2 or m^3/rad: displacement of chamber a per unit of position; > 0
  double area_b = 0.0;               ///< alpha A_p, m^2 or m^3/rad; > 0; equal to area_a for a rotary motor
  double stroke = 0.0;               ///< L_c, m or rad: positions run over [0, stroke]; > 0
  double line_volume_m3 = 0.0;       ///< V_pl, dead volume of each chamber with its line; > 0
  double bulk_modulus_Pa = 0.0;      ///< beta_e, effective; > 0
  double valve_gain = 0.0;           ///< K_v, m^3/s/(A sqrt(Pa)); > 0
  double valve_current_max_A = 0.0;  ///< the valve is full open here, currents beyond it act as this one; > 0
  double supply_pressure_Pa = 0.0;   ///< p_s; > return pressure
  double return_pressure_Pa = 0.0;   ///< p_t; >= 0
  double piston_mass = 0.0;          ///< m_p, kg or kg m^2; >= 0
  double piston_damping = 0.0;       ///< d_p, Ns/m or Nms/rad; >= 0
  double stop_stiffness = 0.0;       ///< of the end stops, N/m or Nm/rad; full supply may press in <= 1 % of stroke
  double stop_damping = 0.0;         ///< of the end stops, Ns/m or Nms/rad; >= 0; both engage within stroke / 1000
  double laminar_pressure_Pa = 1e5;  ///< delta: below this drop an orifice is laminar; > 0 (see orifice_root)
  SpoolParams spool{};               ///< effect valve_dynamics in the plant; off: the spool follows its command
  double valve_deadband_A = 0.0;     ///< effect valve_deadband in the plant; in [0, valve_current_max_A)
  LineParams line{};                 ///< oil inertia in each chamber's line; none unless set. Its volume is in V_pl
};

/// Load behind the load cell: m_l a = F_s - d_l v - F_dry - C (x - x_eq) + F_ext.
struct LoadParams {
  double mass = 0.0;                  ///< m_l, kg or kg m^2; >= 0, and > 0 together with the piston mass
  double damping = 0.0;               ///< d_l, Ns/m or Nms/rad; >= 0
  double stiffness = 0.0;             ///< C = k_1 + k_2, N/m or Nm/rad; >= 0
  double equilibrium_position = 0.0;  ///< x_eq, m or rad, where the load spring is slack
  FrictionParams friction{};          ///< F_dry: effect load_friction in the plant; none unless set
  FlexibleParams flexible{};          ///< effect flexible_load in the plant; none unless set
};

/// State (2.29): pressures are absolute and never negative.
struct State {
  double position = 0.0;       ///< x_p, m or rad, from fully retracted
  double velocity = 0.0;       ///< m/s or rad/s
  double pressure_a_Pa = 0.0;  ///< p_a
  double pressure_b_Pa = 0.0;  ///< p_b
};

/// Refuses values no machine has, naming every one of them with its value.
Result<Done> validate(const ActuatorParams& actuator);
Result<Done> validate(const LoadParams& load);
Result<Done> validate(const ActuatorParams& actuator, const State& state);

/// Speed at which the full-open valve moves an unloaded symmetric actuator: K_v u_max sqrt(p_s) / A_p.
/// The natural unit of velocity for tolerances, m/s or rad/s.
double velocity_scale(const ActuatorParams& actuator) noexcept;

/// Rest state that holds `external_force` (N or Nm, positive along +position) at `position`. The velocity is 0 and the
/// load pressure A_p p_l = C (x - x_eq) - F_ext. The chamber pressures are the mean of (3.19) and (3.20) over both
/// valve signs, raised together if one would be below the return pressure.
State equilibrium(const ActuatorParams& actuator, const LoadParams& load, double position, double external_force);

}  // namespace farrier::plant
