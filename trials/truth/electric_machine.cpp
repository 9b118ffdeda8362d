#include "trials/truth/electric_machine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trials/truth/contact.hpp"
#include "trials/truth/wave.hpp"

namespace farrier::truth::electric {
namespace {

/// Torque of a spring that is bent by `bend`, with a gap about its middle. In the gap nothing pushes; at its flanks the
/// damper engages over a twentieth of the gap.
double spring_torque(double stiffness, double damping, double gap, double bend, double rate) {
  if (gap <= 0.0) {
    return stiffness * bend + damping * rate;
  }
  const double depth = std::abs(bend) - 0.5 * gap;
  if (depth <= 0.0) {
    return 0.0;
  }
  const double side = bend > 0.0 ? 1.0 : -1.0;
  const double engaged = std::min(1.0, depth / (0.05 * gap));
  return side * std::max(0.0, stiffness * depth + damping * engaged * rate * side);
}

double smooth_friction(double level, double speed, double slip) {
  return level * speed / std::sqrt(speed * speed + slip * slip);
}

double admitted(const ElectricMachine& m, double command_A, double rotor_speed) {
  const double limit = m.limit_A > 0.0 ? std::min(m.limit_A, m.current_max_A) : m.current_max_A;
  const double asked = std::clamp(command_A, -limit, limit);
  if (!m.rigid) {
    return asked;
  }
  // A current source is bounded by its voltage: R i + N K w within +-V.
  const double back = m.gear_ratio * m.motor_constant_Nm_A * rotor_speed;
  return std::clamp(asked, std::clamp((-m.voltage_V - back) / m.resistance_Ohm, -m.current_max_A, m.current_max_A),
                    std::clamp((m.voltage_V - back) / m.resistance_Ohm, -m.current_max_A, m.current_max_A));
}

double on_load(const ElectricMachine& m, double time_s, const Vector& x, const Acting& acting, Vector& dx) {
  const double place = x[kX];
  const double from_rest = place - m.spring_rest;
  double torque = acting.random_Nm + m.external_torque + wave(m.beat_Nm, m.beat_rad_s * time_s);
  torque -= m.load_damping * x[kV] + m.load_spring * from_rest + m.cubic_spring * from_rest * from_rest * from_rest;
  torque -= wave(m.weight_Nm, place - m.hanging);
  torque -= rub(m.load_contact, place - 0.5 * m.travel, x[kV], x[kLoadBristle], dx[kLoadBristle]);
  dx[kBranchX] = dx[kBranchV] = 0.0;
  if (m.branch > 0.0) {
    const double pull = m.branch_spring * (place - x[kBranchX]) + m.branch_damping * (x[kV] - x[kBranchV]);
    dx[kBranchX] = x[kBranchV];
    dx[kBranchV] = pull / m.branch;
    torque -= pull;
  }
  return torque;
}

}  // namespace

double differentiate(const ElectricMachine& m, double time_s, const Vector& x, const Acting& acting, Vector& dx) {
  const double strength = m.gear_ratio * m.motor_constant_Nm_A * (1.0 - m.fade_per_s * std::max(time_s, 0.0));
  const bool apart = !m.rigid || m.gear_stiffness > 0.0;
  const double rotor_speed = apart ? x[kRotor] : x[kV];
  const double rotor_place = apart ? x[kX] + x[kBend] : x[kX];
  const double asked = admitted(m, acting.command_A, rotor_speed);

  dx[kLagged] = 0.0;
  double sensed = 0.0;
  if (m.rigid) {
    dx[kCurrent] = (asked - x[kCurrent]) / (m.current_time_s + m.command_lag_s);
    sensed = m.assumed_constant_Nm_A * x[kCurrent];
  } else {
    double across = asked;
    if (m.command_lag_s > 0.0) {
      dx[kLagged] = (asked - x[kLagged]) / m.command_lag_s;
      across = x[kLagged];
    }
    dx[kCurrent] = (m.resistance_Ohm * (across - x[kCurrent]) - strength * rotor_speed) / m.inductance_H;
  }

  double motor = strength * x[kCurrent] - m.damping * rotor_speed -
                 smooth_friction(m.coulomb, rotor_speed, m.slip_speed) +
                 wave(m.ripple_Nm, m.ripple_periods * rotor_place + m.ripple_phase);
  motor -= rub(m.gear_contact, 0.0, rotor_speed, x[kGearBristle], dx[kGearBristle]);

  const double load_torque = on_load(m, time_s, x, acting, dx);
  const double inertia = m.load - m.branch;
  dx[kX] = x[kV];
  if (apart) {
    const double gear = m.rigid ? spring_torque(m.gear_stiffness, m.gear_damping, m.play, x[kBend], x[kRotor] - x[kV])
                                : spring_torque(m.spring, m.spring_damping, m.play, x[kBend], x[kRotor] - x[kV]);
    sensed = m.rigid ? sensed : gear;
    dx[kBend] = x[kRotor] - x[kV];
    dx[kRotor] = (motor - gear) / m.rotor;
    dx[kV] = (gear + load_torque) / inertia;
  } else {
    dx[kBend] = dx[kRotor] = 0.0;
    dx[kV] = (motor + load_torque) / (inertia + m.rotor);
  }
  dx[kSensorLag] = m.sensor_lag_s > 0.0 ? (m.sensor_gain * sensed - x[kSensorLag]) / m.sensor_lag_s : 0.0;
  dx[kVelocityLag] = m.velocity_lag_s > 0.0 ? (x[kV] - x[kVelocityLag]) / m.velocity_lag_s : 0.0;
  return sensed;
}

void advance(const ElectricMachine& m, double time_s, double h, const Acting& acting, Vector& x) {
  Vector k1, k2, k3, k4, middle;
  const auto moved = [&](const Vector& slope, double step) {
    for (std::size_t i = 0; i < kPlaces; ++i) {
      middle[i] = x[i] + step * slope[i];
    }
    return middle;
  };
  differentiate(m, time_s, x, acting, k1);
  differentiate(m, time_s + 0.5 * h, moved(k1, 0.5 * h), acting, k2);
  differentiate(m, time_s + 0.5 * h, moved(k2, 0.5 * h), acting, k3);
  differentiate(m, time_s + h, moved(k3, h), acting, k4);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    x[i] += h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
  }
}

}  // namespace farrier::truth::electric
