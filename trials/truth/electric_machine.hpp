#pragma once

#include <array>
#include <cstddef>

#include "trials/truth/machine.hpp"

namespace farrier::truth {

/// Numbers of one electric joint as it really is, seen at the gear's output but for the motor's own. SI. Numbers of
/// effects that are not hidden are neutral.
struct ElectricMachine {
  bool rigid;                              ///< no spring: the drive controls its current
  double motor_constant_Nm_A, gear_ratio;  ///< K of the rotor, N
  double resistance_Ohm, inductance_H, voltage_V, current_max_A;
  double rotor;                         ///< J N^2, kg m^2
  double damping, coulomb, slip_speed;  ///< of rotor and gear
  double spring, spring_damping;        ///< k, b; not of a rigid drive
  double current_time_s;                ///< with which a rigid drive's current follows
  double travel;
  double load, load_damping, load_spring, spring_rest;
  double assumed_constant_Nm_A;  ///< N K by which a rigid drive turns its current into a torque

  double delay_s = 0.0;
  double command_lag_s = 0.0;                                        ///< before the winding, or added to current_time_s
  double limit_A = 0.0;                                              ///< of the command; 0: none beside current_max_A
  double ripple_Nm = 0.0, ripple_periods = 0.0, ripple_phase = 0.0;  ///< cogging, periods per turn of the output
  double gear_stiffness = 0.0, gear_damping = 0.0;                   ///< of a rigid drive's gear; 0: rotor is load
  double play = 0.0;                                                 ///< whole gap in the gear
  double weight_Nm = 0.0, hanging = 0.0;  ///< largest torque of a weight, and the position at which it hangs
  double cubic_spring = 0.0;              ///< Nm/rad^3
  double external_torque = 0.0;
  double sensor_lag_s = 0.0, sensor_gain = 1.0, sensor_offset = 0.0, velocity_lag_s = 0.0;
  Contact load_contact, gear_contact;

  double fade_per_s = 0.0;                                         ///< of the motor's constant, relative
  double branch = 0.0, branch_spring = 0.0, branch_damping = 0.0;  ///< part of the load behind a spring
  double beat_Nm = 0.0, beat_rad_s = 0.0;                          ///< sinusoidal torque on the load
  double random_Nm = 0.0, random_time_s = 0.05;                    ///< std of a first-order random torque on it
  double dropout = 0.0;                                            ///< chance that a 15 ms block of commands is lost
};

namespace electric {

/// Places in the state.
enum Place : std::size_t {
  kX,
  kV,
  kBend,
  kRotor,
  kCurrent,
  kLagged,
  kLoadBristle,
  kGearBristle,
  kSensorLag,
  kVelocityLag,
  kBranchX,
  kBranchV,
  kPlaces
};
using Vector = std::array<double, kPlaces>;

struct Acting {
  double command_A = 0.0;  ///< after the delay
  double random_Nm = 0.0;
};

/// Derivative of the state `time_s` after recording began. Returns the torque at the sensor, before its electronics:
/// of a rigid drive that which it makes of its current.
double differentiate(const ElectricMachine& m, double time_s, const Vector& x, const Acting& acting, Vector& dx);

/// One classical Runge-Kutta step of fourth order.
void advance(const ElectricMachine& m, double time_s, double h, const Acting& acting, Vector& x);

}  // namespace electric
}  // namespace farrier::truth
