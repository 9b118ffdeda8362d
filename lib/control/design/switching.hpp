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
/// leaves unchanged. They are the command in place of the sum, position (full-state form only), velocity, force and
/// past inputs, all normalised. The model `before` is that of the plant in the tick before a change to this loop.
/// Derivation: docs/derivations/switching.md. Not finite if the gains have no integral action.
SwitchedLoop switched_loop(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                           const DiscreteModel& before) noexcept;

/// Stability of arbitrary switching between two loops.
struct SwitchingVerdict {
  bool common = false;  ///< a common quadratic Lyapunov function was found
  int dwell_ticks = 0;  ///< each loop must act at least this long; kNoDwell when no bound was found
  double rate = 1.0;    ///< per tick, over a long time: the functions' roots shrink at least by this factor; below one
};

inline constexpr int kNoDwell = 1 << 20;

/// Searches for a common quadratic Lyapunov function P of both loops, A_i'PA_i < P, and, if a change costs something,
/// of the change and the tick after. Any switching that stays at least dwell_ticks is then stable; they are 1, or 2
/// with an entry that differs from the loop. Method: interior point on the margin of those matrix inequalities, at most
/// 60 Newton steps (Boyd, El Ghaoui, Feron and Balakrishnan 1994, "Linear matrix inequalities in system and control
/// theory"). The P found is verified by Cholesky.
///
/// Otherwise returns the least dwell time for which two functions of the single loops bound the growth over a change
/// and back (Hespanha and Morse 1999; Geromel and Colaneri 2006). It is an upper bound of the true one. Returns
/// kNoDwell if a loop is unstable by itself or not finite, or the sizes differ. Allocates nothing.
SwitchingVerdict switching_verdict(const SwitchedLoop& first, const SwitchedLoop& second) noexcept;

/// Verdict on the loops of two models, each under its own gains, where plant and gains change together: a joint's
/// stance and swing. kNoDwell if the gains are normalised differently.
SwitchingVerdict switching_verdict(const DiscreteModel& first_model, const Gains& first_gains,
                                   const DiscreteModel& second_model, const Gains& second_gains,
                                   int delay_ticks) noexcept;

}  // namespace farrier::control
