#pragma once

// Equations of a valve's ports and of the oil in both chambers of an actuator, each once: the plant integrates them,
// linear models differentiate them, fits, the flow law and the grey box evaluate them. T is double, or a number that
// carries derivatives. All values in SI and actuator coordinates: positions in m or rad, areas in m^2 or m^3/rad,
// forces in N or Nm. Equation numbers are those of Hubacher (2014). The order of operations is part of the contract:
// traces keep their bits.

#include <cmath>
#include <type_traits>

namespace farrier::plant {

/// (drop^2 + delta^2)^(1/4), sqrt(Pa): the divisor of orifice_root.
template <class T>
T orifice_divisor(const T& drop_Pa, double laminar_pressure_Pa) noexcept {
  using std::sqrt;
  return sqrt(sqrt(drop_Pa * drop_Pa + laminar_pressure_Pa * laminar_pressure_Pa));
}

/// Signed root of a pressure drop, sqrt(Pa): drop / (drop^2 + delta^2)^(1/4). Odd, smooth, and sqrt(drop) for
/// drop >> delta; near zero it is the laminar flow drop / sqrt(delta). At drop = 10 delta it is 0.25 % below the
/// root. (Borutzky, Barnard and Thoma 2002 motivate the transition; this closed form is Simscape's orifice.)
template <class T>
T orifice_root(const T& drop_Pa, double laminar_pressure_Pa) noexcept {
  return drop_Pa / orifice_divisor(drop_Pa, laminar_pressure_Pa);
}

/// Flow into a chamber through one port, m^3/s, and by how much it falls as the chamber's pressure rises, m^3/s/Pa.
template <class T>
struct PortFlow {
  T flow, slope;
};

/// (2.14), (2.15): q = gain root(drop) with gain = K_v |u|, m^3/s/sqrt(Pa), and drop = p_port - p. The slope is
/// gain / divisor (1 - drop^2 / (2 (drop^2 + delta^2))).
template <class T>
PortFlow<T> port_flow(const T& gain, const T& drop_Pa, double laminar_pressure_Pa) noexcept {
  const T square = drop_Pa * drop_Pa + laminar_pressure_Pa * laminar_pressure_Pa;
  const T divisor = orifice_divisor(drop_Pa, laminar_pressure_Pa);
  return {gain * drop_Pa / divisor, gain / divisor * (1.0 - 0.5 * drop_Pa * drop_Pa / square)};
}

/// Pressures that a four-way valve connects to both chambers, Pa, (2.14), (2.15): the ports carry the sign of u.
template <class T>
struct PortPressures {
  T a_Pa, b_Pa;
};
template <class T>
PortPressures<T> port_pressures(bool extends, const T& supply_Pa, const T& return_Pa) noexcept {
  return {extends ? supply_Pa : return_Pa, extends ? return_Pa : supply_Pa};
}

/// Volumes of both chambers with their lines, m^3.
template <class T>
struct ChamberVolumes {
  T a_m3, b_m3;
};

/// No chamber is taken smaller than this share of its line's volume.
inline constexpr double kSmallestVolumeShare = 0.25;

/// (2.12) V_a = V_pl + A_p x, (2.13) V_b = V_pl + (L_c - x) alpha A_p. `actuator` has the fields line_volume_m3,
/// area_a, area_b and stroke of ActuatorParams.
template <class Actuator, class Position>
auto chamber_volumes(const Actuator& actuator, const Position& position) noexcept {
  using T = std::remove_cvref_t<decltype(actuator.line_volume_m3 + actuator.area_a * position)>;
  return ChamberVolumes<T>{actuator.line_volume_m3 + actuator.area_a * position,
                           actuator.line_volume_m3 + actuator.area_b * (actuator.stroke - position)};
}

/// The volumes, or `smallest_m3` for a chamber that would be smaller.
template <class T>
ChamberVolumes<T> at_least(double smallest_m3, const ChamberVolumes<T>& volumes) noexcept {
  return {volumes.a_m3 > smallest_m3 ? volumes.a_m3 : T(smallest_m3),
          volumes.b_m3 > smallest_m3 ? volumes.b_m3 : T(smallest_m3)};
}

/// F_h = A_p (p_a - alpha p_b), (2.8). `actuator` has the fields area_a and area_b of ActuatorParams.
template <class Actuator, class T>
T hydraulic_force(const Actuator& actuator, const T& pressure_a_Pa, const T& pressure_b_Pa) noexcept {
  return actuator.area_a * pressure_a_Pa - actuator.area_b * pressure_b_Pa;
}

/// Pressure of a chamber, Pa: none where it holds a void.
inline double pressure_of(double compression_Pa) noexcept { return compression_Pa > 0.0 ? compression_Pa : 0.0; }

/// Factor of the piston's motion on a chamber with a void, 1 without: with a void W = -c V / beta_e the balance W' = V'
/// - q asks for c' = beta_e / V (q - V' (1 + c / beta_e)).
inline double filled_share(double compression_Pa, double pressure_Pa, double inverse_bulk_modulus) noexcept {
  return 1.0 + (compression_Pa - pressure_Pa) * inverse_bulk_modulus;
}

/// (2.10), (2.11): p' = beta_e / V (q - V'), Pa/s, for the chamber's stiffness beta_e / V, Pa/m^3, its inflow and its
/// growth V', m^3/s.
template <class T>
T pressure_rate(const T& stiffness_Pa_m3, const T& inflow_m3_s, const T& growth_m3_s) noexcept {
  return stiffness_Pa_m3 * (inflow_m3_s - growth_m3_s);
}

/// The same for an inflow flow / root: an orifice's root goes into the chamber's own division.
inline double pressure_rate(double bulk_modulus_Pa, double volume_m3, double flow, double root,
                            double growth_m3_s) noexcept {
  return bulk_modulus_Pa * (flow - growth_m3_s * root) / (volume_m3 * root);
}

}  // namespace farrier::plant
