#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace farrier::plant {

/// Inflow of both chambers, m^3/s: fractions flow / root, as an orifice's root goes into the chamber's own division, and
/// what flows past the valve.
struct ChamberFeed {
  double flow_a, root_a;
  double flow_b, root_b;
  double past_a = -0.0, past_b = -0.0;
};

/// Values of one evaluation of the joint's equations that effects may read and change, in the order of `Effects`.
struct Instant {
  double command_A;     ///< the held current, within the valve's limits
  double velocity;      ///< of piston and load, m/s or rad/s
  double chamber_a_Pa;  ///< pressures in the chambers
  double chamber_b_Pa;
  double opening_A;   ///< current that opens the valve: the command until effects change it
  double valve_a_Pa;  ///< pressures behind the valve: those of the chambers until effects change them
  double valve_b_Pa;
  ChamberFeed feed;             ///< inflow of the chambers: the valve's until effects change it
  double load_force;            ///< on the load, positive along +position: the external force until effects add theirs
  double position = 0.0;        ///< of piston and load, m or rad
  double flow_factor = 1.0;     ///< on the valve gain
  double supply_fall_Pa = 0.0;  ///< by which the valve's supply is below the nominal one
  double leakage_m3_s = 0.0;    ///< from chamber a to b
  double into_a_m3_s = 0.0;     ///< past the valve's closed lands, into the chambers
  double into_b_m3_s = 0.0;
  double past_lands_m3_s = 0.0;  ///< past them from the supply
  double softness_a = 0.0;       ///< 1/beta beyond the oil's own, 1/Pa
  double softness_b = 0.0;
  double play_slope = 0.0;    ///< d(piston - load) / d(force), m/N or rad/Nm
  double seal_rate = 0.0;     ///< of the force of the piston's seals, N/s or Nm/s
  double piston_force = 0.0;  ///< on the piston, left of the load cell, positive along +position
};

/// Pressures and speed of the joint when it is created: valve shut.
struct RestPoint {
  double pressure_a_Pa;
  double pressure_b_Pa;
  double velocity = 0.0;  ///< m/s or rad/s
};

/// Integration of an effect whose term in plant/terms has a state (EffectInfo::has_state), and of the lines. Each is a
/// class derived from this (static, no virtual call) in a file of its own and an entry of the tuple in effects.hpp; it
/// overrides the hooks it needs. The term has the equation's source and the parameters. An effect without a state has
/// no class here: see StatelessTerms. An effect with neutral parameters is not active, and a joint without active
/// effects runs the equations without any.
///
/// `x` are its kStates states, `dx` their rates. Hooks are noexcept and use +, -, *, /, sqrt only.
template <std::size_t States>
struct Effect {
  static constexpr std::size_t kStates = States;
  /// True if the hooks change nothing while the effect is not active, so that they need not be asked first.
  static constexpr bool kNeutralUnlessActive = false;
  using X = std::array<double, States>;

  bool active() const noexcept { return false; }
  /// Fastest rate it brings into the model, 1/s, for the shortest substep.
  double fastest_rate(double /*mass*/) const noexcept { return 0.0; }
  /// Unit of each state for tolerances: an error of `tolerance` times this counts as one.
  X scale() const noexcept { return {}; }
  X rest(const RestPoint&) const noexcept { return {}; }
  /// Before the valve's flow is known: may change opening_A and the pressures behind the valve.
  void before_valve(Instant&, const X&) const noexcept {}
  /// After: may change the chambers' feed and the load's force, and gives the rates of its states.
  void after_valve(Instant&, const X&, X&) const noexcept {}
  /// True if the rates bend sharply where the velocity changes its sign.
  bool bends_at_rest() const noexcept { return false; }
  /// After a substep: may put states that have settled to their steady values.
  void settle(double /*velocity*/, X& /*x*/, X& /*dx*/) const noexcept {}
};

}  // namespace farrier::plant
