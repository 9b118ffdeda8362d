#pragma once

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <limits>

#include "plant/actuator.hpp"

// The equations of Hubacher (2014), Chapters 2 and 3, written out once more and for complex numbers: what printed forms
// are held against. Differentiated by a complex step (Squire and Trapp 1998), exact to rounding.

namespace farrier::thesis {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kEps = std::numeric_limits<double>::epsilon();
/// Rounding of a derivative of some thirty operations.
inline constexpr double kRounding = 100.0 * kEps;

/// Table A.1: cylinder, oil and valve.
inline plant::ActuatorParams cylinder() {
  plant::ActuatorParams p;
  p.area_a = 2.0106e-4;
  p.area_b = 0.6094 * p.area_a;
  p.stroke = 0.08;
  p.line_volume_m3 = 3.4023e-6;
  p.bulk_modulus_Pa = 1.3e9;
  p.valve_gain = 6.6815e-6;
  p.valve_current_max_A = 0.01;
  p.supply_pressure_Pa = 250e5;
  p.return_pressure_Pa = 0.0;
  p.piston_mass = 0.3141;
  p.piston_damping = 700.0;
  p.stop_stiffness = 1e8;
  p.stop_damping = 1e4;
  return p;
}

/// Table A.1: load, slack at mid-stroke (2.23).
inline plant::LoadParams load() { return {10.0, 700.0, 21480.0, 0.04}; }

inline double alpha(const plant::ActuatorParams& p) { return p.area_b / p.area_a; }

template <class Scalar>
using State = Eigen::Matrix<Scalar, 4, 1>;  // x_p, v, p_a, p_b, (2.29)

/// Operating point of Section 3.1: mid-stroke, at rest, p_a = alpha p_s / (1 + alpha), p_b = p_s / (1 + alpha).
inline State<double> nominal_state() {
  const auto p = cylinder();
  return {0.5 * p.stroke, 0.0, alpha(p) * p.supply_pressure_Pa / (1.0 + alpha(p)),
          p.supply_pressure_Pa / (1.0 + alpha(p))};
}

/// (2.30a) for sign > 0, (2.30b) for sign < 0.
template <class Scalar>
State<Scalar> full_rate(const State<Scalar>& s, Scalar current_A, double sign) {
  const auto p = cylinder();
  const auto l = load();
  const Scalar size = sign * current_A;  // |u| on this branch
  const Scalar drop_a = sign > 0.0 ? p.supply_pressure_Pa - s(2) : s(2) - p.return_pressure_Pa;
  const Scalar drop_b = sign > 0.0 ? s(3) - p.return_pressure_Pa : p.supply_pressure_Pa - s(3);
  const Scalar flow_a = sign * p.valve_gain * size * std::sqrt(drop_a);
  const Scalar flow_b = sign * p.valve_gain * size * std::sqrt(drop_b);
  const Scalar force = p.area_a * s(2) - p.area_b * s(3) - (l.damping + p.piston_damping) * s(1) -
                       l.stiffness * (s(0) - l.equilibrium_position);
  State<Scalar> rate;
  rate << s(1), force / (l.mass + p.piston_mass),
      p.bulk_modulus_Pa / (p.line_volume_m3 + p.area_a * s(0)) * (flow_a - p.area_a * s(1)),
      p.bulk_modulus_Pa / (p.line_volume_m3 + p.area_b * (p.stroke - s(0))) * (p.area_b * s(1) - flow_b);
  return rate;
}

struct FullModel {
  Eigen::Matrix4d a;
  Eigen::Vector4d b;
};

inline FullModel full_model(const State<double>& point, double current_A, double sign) {
  using Complex = std::complex<double>;
  constexpr double kStep = 1e-30;
  FullModel model;
  for (int column = 0; column < 4; ++column) {
    State<Complex> state = point.cast<Complex>();
    state(column) += Complex(0.0, kStep);
    model.a.col(column) = full_rate<Complex>(state, current_A, sign).imag() / kStep;
  }
  model.b = full_rate<Complex>(point.cast<Complex>(), Complex(current_A, kStep), sign).imag() / kStep;
  return model;
}

/// Partial derivatives of the load pressure's rate, (3.23)-(3.26), with (3.27)-(3.33).
struct LoadPressureRate {
  double pressure;   ///< k_1, 1/s
  double position;   ///< k_2, Pa/(m s)
  double velocity;   ///< k_3, Pa/m
  double current;    ///< k_4, Pa/(A s)
  double k_pl;       ///< (3.29), sqrt(Pa)/s
  double k_xpa;      ///< (3.30)
  double k_xpb;      ///< (3.31)
  double k_uv;       ///< (3.33)
};

inline LoadPressureRate load_pressure_rate(double position, double velocity, double load_pressure_Pa,
                                           double current_A, double sign) {
  const auto p = cylinder();
  const double ratio = alpha(p);
  const double v_a = p.line_volume_m3 + position * p.area_a;
  const double v_b = p.line_volume_m3 + (p.stroke - position) * p.area_b;
  const double valve = p.valve_gain / std::sqrt(1.0 + ratio * ratio * ratio);
  const double root = std::sqrt(sign > 0.0 ? p.supply_pressure_Pa - load_pressure_Pa - ratio * p.return_pressure_Pa
                                           : ratio * p.supply_pressure_Pa + load_pressure_Pa - p.return_pressure_Pa);
  const double beta = p.bulk_modulus_Pa;
  const double stiffness = beta * (1.0 / v_a + ratio * ratio / v_b);
  const double slope = beta * p.area_a * (1.0 / (v_a * v_a) - ratio * ratio * ratio / (v_b * v_b));
  LoadPressureRate k;
  k.k_pl = -0.5 * valve * std::abs(current_A) * stiffness;
  k.k_xpa = valve * std::abs(current_A) * slope;
  k.k_xpb = p.area_a * slope;
  k.k_uv = valve * stiffness;
  k.pressure = k.k_pl / root;
  k.position = -sign * k.k_xpa * root + k.k_xpb * velocity;
  k.velocity = -p.area_a * stiffness;
  k.current = k.k_uv * root;
  return k;
}

inline double decibels(double ratio) { return 20.0 * std::log10(ratio); }
inline double degrees(double radians) { return radians * 180.0 / kPi; }

}  // namespace farrier::thesis
