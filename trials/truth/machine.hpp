#pragma once

#include <array>
#include <cstddef>

namespace farrier::truth {

/// LuGre contact (Canudas de Wit, Olsson, Astrom, Lischinsky 1995). coulomb 0: none.
struct Contact {
  double coulomb = 0.0;            ///< N or Nm
  double breakaway = 0.0;          ///< N or Nm, >= coulomb
  double stribeck_velocity = 1.0;  ///< m/s or rad/s
  double presliding = 1.0;         ///< m or rad: bristles bend so far under the breakaway force
  double bristle_damping = 0.0;    ///< Ns/m or Nms/rad, fades with the Stribeck curve
  double waviness = 0.0;           ///< in [0, 1): level is 1 + waviness sin(2 pi (x - x_mid) / wavelength)
  double wavelength = 1.0;         ///< m or rad
};

/// Numbers of one joint as it really is. SI; lengths and forces m, N (cylinder) or rad, Nm (rotary). Numbers of effects
/// that are not hidden are neutral.
struct Machine {
  double area_a, area_b, stroke, line_volume_m3, bulk_modulus_Pa, valve_gain, current_max_A;
  double supply_Pa, return_Pa, laminar_Pa;
  double piston_mass, piston_damping, stop_stiffness, stop_damping;
  double load_mass, load_damping, load_stiffness, spring_rest;  ///< spring_rest: where the load spring is slack

  double overlap_A = 0.0;    ///< of each land
  double bias_A = 0.0;       ///< added to the command
  double asymmetry = 0.0;    ///< gain K (1 + r) extending, K (1 - r) retracting
  double spool_rad_s = 0.0;  ///< 0: the spool follows at once
  double spool_damping = 0.7;
  double port_current_A = 0.0;  ///< opening at which a land has the resistance of the port's bore; 0: wide bore
  double delay_s = 0.0;
  Contact load_contact, piston_contact;
  double leakage_m3_s_Pa = 0.0;    ///< laminar, from a to b
  double air_fraction = 0.0;       ///< of the volume, at 1 bar
  double supply_resistance = 0.0;  ///< Pa s/m^3, laminar, between pump and valve
  double cubic_stiffness = 0.0;    ///< N/m^3 or Nm/rad^3
  double external_force = 0.0;     ///< on the load
  double play = 0.0;               ///< whole gap between piston and load; 0: rigid
  double stop_inset = 0.0;         ///< both stops stand so far inside [0, stroke]
  double force_lag_s = 0.0, force_gain = 1.0, force_offset = 0.0, velocity_lag_s = 0.0;

  double ripple_Pa = 0.0, ripple_rad_s = 0.0;          ///< of the pump
  double accumulator_Pa_m3 = 0.0;                      ///< stiffness of an accumulator at the valve; 0: none
  double feed_inertance = 0.0, feed_resistance = 0.0;  ///< of the line that feeds it, Pa s^2/m^3, Pa s/m^3
  double hysteresis_A = 0.0;                           ///< half width of the play in the command
  double gain_loss_per_s = 0.0;                        ///< of the valve's gain, relative
  double branch_share = 0.0, branch_rad_s = 0.0, branch_damping = 0.0;  ///< part of the load behind a spring
  double crosstalk = 0.0;                                 ///< gain of the load cell, 1/m or 1/rad off mid-stroke
  double beat_force = 0.0, beat_rad_s = 0.0;              ///< sinusoidal force on the load
  double random_force = 0.0, random_force_time_s = 0.05;  ///< std of a first-order random force on the load
  double dropout = 0.0;                                   ///< chance that a command of a 15 ms block is not taken
};

/// Places in the state.
enum Place : std::size_t {
  kX,
  kV,
  kPistonX,
  kPistonV,
  kPa,
  kPb,
  kSpool,
  kSpoolRate,
  kLoadBristle,
  kPistonBristle,
  kForceLag,
  kVelocityLag,
  kSupply,
  kFeed,
  kBranchX,
  kBranchV,
  kPlaces
};
using Vector = std::array<double, kPlaces>;

/// Inputs from outside during a step.
struct Acting {
  double command_A = 0.0;  ///< after delay and hysteresis, with bias
  double random_force = 0.0;
};

/// Results of the equations beside the state's derivative.
struct Outcome {
  double cell_force = 0.0;   ///< at the load cell, before its electronics
  double supply_flow = 0.0;  ///< drawn at the valve, m^3/s, >= 0
  double supply_Pa = 0.0;    ///< at the valve
};

/// Derivative of the state at `time_s` since recording began.
Outcome differentiate(const Machine& machine, double time_s, const Vector& x, const Acting& acting, Vector& dx);

/// One classical Runge-Kutta step of fourth order; pressures that fell below 0 end at 0.
void advance(const Machine& machine, double time_s, double h, const Acting& acting, Vector& x);

/// At rest in mid-stroke, chambers in balance at half the supply pressure in sum.
Vector at_rest(const Machine& machine);

/// Damping of the flanks of the play, Ns/m or Nms/rad: 0.3 of critical for the load on a standing piston, as of oiled
/// steel that rebounds by a third. With less the load rattles in the play without end.
double contact_damping(const Machine& machine);

/// Flow through an orifice of opening 1 per sqrt(Pa), signed as the drop: square root beyond the laminar drop, an odd
/// cubic with the same value and slope below it.
double orifice(double drop_Pa, double laminar_Pa);

}  // namespace farrier::truth
