#pragma once

#include "plant/actuator.hpp"

namespace farrier::plant {

struct OperatingPoint {
  double position = 0.0;          ///< m or rad
  double velocity = 0.0;          ///< m/s or rad/s
  double load_pressure_Pa = 0.0;  ///< p_l = p_a - alpha p_b
  double valve_current_A = 0.0;   ///< only its size counts
  double valve_sign = 0.0;        ///< +1, -1, or 0 for the mean of both signs
};

/// Treatment of the chambers' volumes, which a moving piston changes, in a linear model.
enum class Volumes {
  kMoving,
  kConstant,  ///< the assumption of Hubacher (2014), Section 4.2.1: no derivative with respect to the position
};

/// Rate of the load pressure around an operating point for one sign of the valve, Hubacher (2014) (3.22)-(3.33), in
/// SI. K_xpA and K_xpB are zero with constant volumes.
struct LoadPressureCoefficients {
  double sign;      ///< +1 or -1, of the valve current
  double root;      ///< sqrt(p_s - p_l - alpha p_t) for u > 0, sqrt(alpha p_s + p_l - p_t) for u < 0
  double K_pl;      ///< (3.29)
  double K_xpA;     ///< (3.30)
  double K_xpB;     ///< (3.31)
  double K_vp;      ///< (3.32)
  double K_uv;      ///< (3.33)
  double velocity;  ///< of the operating point

  double by_pressure() const noexcept { return K_pl / root; }                              // (3.23), 1/s
  double by_position() const noexcept { return -sign * K_xpA * root + K_xpB * velocity; }  // (3.24), Pa/(m s)
  double by_velocity() const noexcept { return K_vp; }                                     // (3.25), Pa/m
  double by_current() const noexcept { return K_uv * root; }                               // (3.26), Pa/(A s)
};

/// Coefficients for valve_sign +1 or -1 (checked invariant: a mean of coefficients is no coefficient). The root of the
/// pressure drop is taken no smaller than at the laminar pressure.
LoadPressureCoefficients load_pressure_coefficients(const ActuatorParams& actuator, const OperatingPoint& point,
                                                    Volumes volumes = Volumes::kMoving);

/// Position and velocity of the point with the chamber pressures that keep its load pressure in steady flow,
/// (3.19) and (3.20); for valve_sign 0 the mean of both signs.
State steady_chambers(const ActuatorParams& actuator, const OperatingPoint& point) noexcept;

/// Pressure, Pa, by which a leakage between the chambers is multiplied to give the flow of a valve that makes up for it.
/// It is (p_a - p_b) (1 / V_a + alpha / V_b) / (1 / V_a + alpha^2 / V_b) with the pressures of steady_chambers().
double leakage_pressure_Pa(const ActuatorParams& actuator, const OperatingPoint& point) noexcept;

}  // namespace farrier::plant
