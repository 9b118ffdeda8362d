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

/// True if the shortest substep is stable at that rate, 1/s.
inline bool stable_substep(double rate) noexcept { return rate * kShortestSubstep_s <= kStabilityInterval; }

/// A trial step of equations: their own, or the integrator's.
template <class Equations, class State>
TrialStep<State> trial_step(const Equations& equations, const typename Equations::Input& input, const State& state,
                            const State& derivative, double h) noexcept {
  if constexpr (requires { equations.step(input, state, derivative, h); }) {
    return equations.step(input, state, derivative, h);
  } else {
    return dormand_prince_step<Equations, State>(equations, input, state, derivative, h);
  }
}

/// Length of a substep of `h` at most that ends where the rates bend, if that is soon: no stage looks beyond it then.
/// Equations without such a place take `h`.
template <class Equations, class State>
double up_to_bend(const Equations& equations, const State& state, const State& derivative, double h) noexcept {
  if constexpr (requires { equations.time_to_bend_s(state, derivative); }) {
    constexpr double kAtEnd = 0.999;
    const double bend_s = equations.time_to_bend_s(state, derivative);
    return bend_s > kShortestSubstep_s && bend_s < kAtEnd * h ? bend_s : h;
  } else {
    return h;
  }
}

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
    const double share_s = left_s / shares;
    const double h = up_to_bend(equations, state, derivative, share_s);
    const double wanted_s = h < share_s ? substep_s : 0.0;  // what a bend cuts off says nothing of the next substep
    const bool shortest = substep_s <= kShortestSubstep_s;
    const TrialStep<State> trial = trial_step<Equations, State>(equations, input, state, derivative, h);
    const double ratio = error_ratio(trial, h);
    const bool within = ratio <= 1.0;
    substep_s = std::clamp(h * substep_factor(ratio), kShortestSubstep_s, std::max(period_s, kShortestSubstep_s));
    if (!within && !shortest) {
      ++report.rejected;
      continue;
    }
    substep_s = std::max(substep_s, wanted_s);
    left_s = shares == 1 && h == share_s ? 0.0 : left_s - h;
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
