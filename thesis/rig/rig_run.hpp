#pragma once

// The real-time rig of Hubacher (2014), Chapter 9, as deploy/robots/fc1d_real.yaml has it: one joint between its
// sensors and a controller, or a current that nobody controls. Nothing else of the loop, so that a run of seconds takes
// a fraction of one.

#include <functional>
#include <vector>

#include "thesis/study/study.hpp"

namespace farrier::thesis {

using Signal = std::function<double(double)>;  ///< of the time in s

/// deploy/robots/fc1d_real.yaml: the rig of Figs 1.2, 9.1 to 9.23 and G.1 to G.10.
Result<robot::Robot> load_rig(const StudyContext& context);

/// A run, a value a tick, SI. Forces and motion are the truth; what the controller saw is measured_*.
struct RigTrace {
  double period_s = 0.0;
  std::vector<double> time_s, reference_N, force_N;
  std::vector<double> position_m;  ///< from mid-stroke
  std::vector<double> velocity_m_s, pressure_a_Pa, pressure_b_Pa;
  std::vector<double> load_pressure_Pa;  ///< p_a - alpha p_b
  std::vector<double> measured_position_m, measured_velocity_m_s, measured_force_N;
  std::vector<double> current_A;
  std::vector<double> position_part_A, velocity_part_A, force_part_A, integral_part_A, feed_forward_part_A;
};

/// Weight put on the cart while it runs.
struct AddedWeight {
  double at_s;
  double total_kg;  ///< beyond the swing load's mass
};

/// Gamma over the design's own: the compliant form's term "is very small" (9.2.2, 9.2.4), the full-state form needs it all.
inline constexpr double kSmallFeedForward = 0.1;

/// A force reference on the rig, gains for one load whatever it carries.
struct Tracking {
  Signal reference;
  double duration_s = 2.0;
  control::Kind kind = control::Kind::kLqr;  ///< kLqr, or kFeedbackLinearisation with the robot file's gains
  control::Form form = control::Form::kCompliant;
  double feed_forward_factor = kSmallFeedForward;  ///< replaces that of `weights`
  double integral_factor = 6.0;                    ///< xi (7.11); replaces that of `weights`
  std::vector<AddedWeight> added = {};             ///< in order of time
  control::LqrWeights weights = {};                ///< (7.9), (7.10) unless told
  double designed_for_kg = 0.0;                    ///< weight beyond the swing load's that the gains are for
};

/// Runs `tracking`. Refuses joints that cannot be
/// simulated and loads without a design, with the reason.
Result<RigTrace> track(const robot::Robot& rig, const Tracking& tracking, std::uint64_t seed);

/// A valve current on the rig, its cart made heavier by added_kg.
struct Driving {
  Signal current_A;
  double duration_s = 8.0;
  double added_kg = 0.0;
  double position_m = 0.0;  ///< from mid-stroke, where it starts at rest
};
Result<RigTrace> drive(const robot::Robot& rig, const Driving& driving, std::uint64_t seed);

/// amplitude sin of a frequency that rises evenly from 0 to `to_Hz` over `duration_s`.
Signal chirp(double amplitude, double to_Hz, double duration_s);
Signal sine(double amplitude, double frequency_Hz);

// Measures of a run between two times. A range without ticks gives NaN.

double rms(const RigTrace& run, const std::vector<double>& values, double from_s, double to_s);
/// RMS(F_ref - F) / RMS(F_ref).
double tracking_error(const RigTrace& run, double from_s, double to_s);
/// Lag of the force behind a sine reference of that frequency, degrees, over whole periods from from_s on.
double lag_deg(const RigTrace& run, double frequency_Hz, double from_s);
/// Mean of the values within [from_s, to_s).
double mean(const RigTrace& run, const std::vector<double>& values, double from_s, double to_s);
/// Share of the time within [from_s, to_s) in which the piston stands: slower than the Stribeck velocity's tenth.
double standing(const RigTrace& run, double from_s, double to_s);
/// RMS of the difference to the mean over `window_s` centred: what is quicker than the window.
double ripple(const RigTrace& run, const std::vector<double>& values, double window_s, double from_s, double to_s);

/// Panel of reference and force. The force is cut at three times the reference, as the title then says.
Panel force_panel(const std::string& title, const RigTrace& run);
/// Panel of what a controller's output is made of, over the valve's nominal current.
Panel parts_panel(const RigTrace& run, double current_max_A);

/// `values` times `factor`, for a picture's unit.
std::vector<double> scaled(const std::vector<double>& values, double factor);

}  // namespace farrier::thesis
