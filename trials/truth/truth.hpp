#pragma once

// Recordings of a joint in which an effect is hidden, for blind trials of `farrier diagnose`. The machine is written a
// second time here: of lib/plant only the structs that hold numbers are used, none of its equations.
//
// A run without effect comes first. It gives the scale of the excitation and of effects that are relative to the run.
// Data flow of one run of `record`:
//
//   plan ─▶ hide ─▶ Machine ─▶ Simulator ◀─▶ Driver (current)
//                                  └─▶ sensors ─▶ Samples

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::truth {

enum class Excitation {
  kMultisine,      ///< open loop: a dozen sines of current
  kRandomSteps,    ///< open loop: levels held for a random time
  kForceTracking,  ///< closed loop: a force controller follows sines and steps
};

/// An effect to hide.
struct Hidden {
  std::string name;  ///< of known_effects() or outside_effects()
  int magnitude;     ///< 0 small, 1 medium, 2 large
};

/// Plan of a recording. `seed` gives the machine's deviation from its file, excitation, noise, and sign and exact size
/// of every effect. Each has a stream of its own: plans that differ in `hidden` alone share all the rest.
struct Plan {
  std::uint64_t seed;
  Excitation excitation;
  std::vector<Hidden> hidden;  ///< no name twice
  double duration_s = 8.0;     ///< in [1, 600]
};

/// A hidden effect.
struct Answer {
  std::string name;
  double value;  ///< headline parameter as simulated; its name and unit are headline()'s
};

/// Readings of the sensors: noisy and quantised, SI (m, m/s, N or rad, rad/s, Nm). Row k: sensors at tick k;
/// valve_current_A[k] acts over [k, k + 1).
struct Samples {
  double period_s;
  std::vector<double> valve_current_A, position, velocity, force, pressure_a_Pa, pressure_b_Pa, supply_pressure_Pa;
};

struct Trial {
  Samples samples;
  std::vector<Answer> answers;  ///< in the order of the plan
};

/// Refuses unknown or repeated effects, magnitudes outside 0..2, and a duration or period out of range (period in
/// [2e-4, 5e-3] s). Refuses joints whose file already has spool, deadband, friction or lines: the nominal machine is
/// the plain one. The load is the joint's swing load, the motion about mid-stroke, inside [0.1, 0.9] stroke.
Result<Trial> generate(const robot::Joint& joint, double period_s, const Plan& plan);

/// Effects the library knows, 23 names.
std::vector<std::string> known_effects();

/// Effects it does not know, and that none of these can stand for.
std::vector<std::string> outside_effects();

/// Name of an effect's headline parameter, unit in it where it has one of its own; empty for an unknown effect.
std::string headline(const std::string& effect);

}  // namespace farrier::truth
