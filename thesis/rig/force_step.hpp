#pragma once

#include <span>
#include <vector>

#include "control/design/lqr.hpp"
#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::thesis {

/// A force step on one joint in closed loop: Hubacher (2014), Figs 9.22 and 9.23.
struct ForceStep {
  double from_N = 0.0;
  double to_N = 400.0;
  double begin_s = 0.05;       ///< at rest until then
  double rise_s = 0.0;         ///< over which the reference goes from the one to the other, evenly
  double duration_s = 0.3;     ///< of the whole, in (begin_s, 10]
  control::Form form = control::Form::kCompliant;
  bool heavy = false;          ///< the stance load instead of the swing load
  std::uint64_t seed = 1;
  int samples_per_tick = 20;   ///< at least; of the simulated joint
};

/// The joint between two ticks; controller and measurements as held there.
struct ForceStepSample {
  double time_s;
  double reference_N;
  double force_N;               ///< load cell, true
  double position_m;
  double velocity_m_s;          ///< true
  double measured_velocity_m_s;
  double load_pressure_Pa;      ///< p_a - alpha p_b, chambers
  double line_load_pressure_Pa; ///< the same behind the valve; the chambers' without lines
  double valve_current_A;
  double velocity_part_A;       ///< of the current
  double opening_A;
  double friction_N;
};

/// Runs the step with gains by the robot's own rule, plant, effects and sensors. Refuses robots with more than one
/// joint, a joint that cannot be simulated, no stable design for it, and times out of range, with the reason.
Result<std::vector<ForceStepSample>> run_force_step(const robot::Robot& rig, const ForceStep& step);

/// Properties of a quick oscillation of the load pressure.
struct Oscillation {
  double frequency_Hz = 0.0;   ///< mean over the crossings while it is above a tenth of its largest; 0: fewer than four
  double peak_Pa = 0.0;        ///< largest deviation from the moving mean
  double begin_s = 0.0;        ///< when it first exceeds a tenth of that, to within half a window
  double decay_s = 0.0;        ///< from the largest until it stays below a tenth of it
};

/// Deviation of the load pressure behind the valve (or of the chambers, `at_chambers`) from its mean over `window_s`
/// centred, within [from_s, to_s]. `window_s` decides what counts as quick: slower than 1 / window_s is taken out.
Oscillation load_pressure_oscillation(std::span<const ForceStepSample> samples, double from_s, double to_s,
                                      double window_s = 0.01, bool at_chambers = true);

}  // namespace farrier::thesis
