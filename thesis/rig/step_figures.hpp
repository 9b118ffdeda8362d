#pragma once

// A step of the force reference on the rig and its figures, as Figs 9.13 and 9.15 show it.

#include <vector>

#include "thesis/rig/rig_run.hpp"

namespace farrier::thesis {

inline constexpr double kStep_s = 0.5;     ///< when it comes
inline constexpr double kStepRun_s = 1.5;  ///< of the whole run

Signal step(double from_N, double to_N);

/// Overshoot of the force beyond the new reference, over the step.
double overshoot(const RigTrace& run, double from_N, double to_N);

/// Time from the step until the force has gone nine tenths of the way; the run's length when it never does.
double rise_s(const RigTrace& run, double from_N, double to_N);

/// Time from the step from which on the force stays within a tenth of it.
double settled_s(const RigTrace& run, double from_N, double to_N);

/// Size of the mean error over the run's last 0.2 s, over the step.
double steady_error(const RigTrace& run, double from_N, double to_N);

/// Largest of the values' sizes within [from_s, to_s), 0.15 s of the step unless told.
double largest(const RigTrace& run, const std::vector<double>& values, double from_s = kStep_s,
               double to_s = kStep_s + 0.15);

}  // namespace farrier::thesis
