#pragma once

#include "control/design/lqr.hpp"
#include "control/numerics/spectrum.hpp"

namespace farrier::control {

/// One of two loops that a joint changes between, both in the same coordinates.
struct SwitchedLoop {
  SmallMatrix loop;   ///< transition of a tick
  SmallMatrix entry;  ///< transition of the first tick after a change to this loop; `loop` where a change costs nothing
};

/// The closed loop of `model` under `gains` in coordinates that a bumpless change of gains (ForceController::set_gains)
/// leaves alone: the command in place of the sum, then position (full-state form only), velocity, force and past
/// inputs, all normalised. `before` is the model of the plant in the tick before a change to this loop. Derivation:
/// docs/derivations/switching.md. Not finite when the gains have no integral action.
SwitchedLoop switched_loop(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                           const DiscreteModel& before) noexcept;

/// What is known of switching between two loops at any time, as often as one likes.
struct SwitchingVerdict {
  bool common = false;   ///< a common quadratic Lyapunov function was found
  int dwell_ticks = 0;   ///< each loop must act at least this long; kNoDwell when no bound was found
  double rate = 1.0;     ///< per tick, over a long time: what the functions' roots shrink by at least; below one
};

inline constexpr int kNoDwell = 1 << 20;

/// Looks for a common quadratic Lyapunov function P of both loops, A_i'PA_i < P, and, where a change costs something,
/// of change and the tick after: then any switching that stays at least dwell_ticks (1, or 2 with an entry that is not
/// the loop) is stable. Interior point on the margin of those matrix inequalities, at most 60 Newton steps
/// (Boyd, El Ghaoui, Feron and Balakrishnan 1994, "Linear matrix inequalities in system and control theory");
/// the P found is judged by Cholesky, whatever way it was found.
/// Otherwise the least dwell time for which two functions of the single loops bound the growth over a change and back
/// (Hespanha and Morse 1999; Geromel and Colaneri 2006): an upper bound of the true one.
/// kNoDwell when a loop is unstable by itself, not finite, or the sizes differ. Allocates nothing.
SwitchingVerdict switching_verdict(const SwitchedLoop& first, const SwitchedLoop& second) noexcept;

/// Of the loops of two models, each under its own gains, where plant and gains change together: a joint's stance and
/// swing. kNoDwell when the gains are normalised differently.
SwitchingVerdict switching_verdict(const DiscreteModel& first_model, const Gains& first_gains,
                                   const DiscreteModel& second_model, const Gains& second_gains,
                                   int delay_ticks) noexcept;

}  // namespace farrier::control
