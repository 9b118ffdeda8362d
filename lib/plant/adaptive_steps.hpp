#pragma once

#include <algorithm>

#include "plant/runge_kutta.hpp"
#include "plant/step_report.hpp"
#include "plant/substep_control.hpp"

namespace farrier::plant {

/// No substep is requested shorter than this; the last one of a period may be.
inline constexpr double kShortestSubstep_s = 1e-5;
/// Keeps a remainder of exactly n substeps at n shares.
inline constexpr double kJustBelowOne = 1.0 - 1e-9;
/// Real stability interval of RK5(4)7M is 3.3; substeps at the bound must lie inside it.
inline constexpr double kStabilityInterval = 3.3;

/// Advances `state` and its `derivative` by a period with the input held. The errors `error_ratio(trial, h)` of its
/// substeps, relative to their bounds, are at most 1, or the requested length is the shortest. The next substep's
/// length is in `substep_s`. After each substep `look()` is called. Returns the relative error of the whole.
template <class Equations, class State, class ErrorRatio, class Look>
double advance_adaptively(const Equations& equations, const typename Equations::Input& input, State& state,
                          State& derivative, double period_s, double& substep_s, StepReport& report,
                          ErrorRatio error_ratio, Look look) noexcept {
  double left_s = period_s;
  double relative_error = 0.0;
  while (left_s > 0.0) {
    const int shares = 1 + static_cast<int>(kJustBelowOne * left_s / substep_s);
    const double h = left_s / shares;
    const bool shortest = substep_s <= kShortestSubstep_s;
    const TrialStep<State> trial = dormand_prince_step<Equations, State>(equations, input, state, derivative, h);
    const double ratio = error_ratio(trial, h);
    const bool within = ratio <= 1.0;
    substep_s = std::clamp(h * substep_factor(ratio), kShortestSubstep_s, std::max(period_s, kShortestSubstep_s));
    if (!within && !shortest) {
      ++report.rejected;
      continue;
    }
    left_s = shares == 1 ? 0.0 : left_s - h;
    ++report.substeps;
    report.bound_hit |= !within;
    if (within || finite(trial.state)) {
      state = trial.state;
      derivative = trial.end_derivative;
      relative_error += ratio;
    }
    look();
  }
  return relative_error;
}

}  // namespace farrier::plant
