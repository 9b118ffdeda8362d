#pragma once

#include <array>
#include <complex>

#include "control/lqr.hpp"

namespace farrier::control {

/// Poles of a loop: integrator, position, velocity, force and two past inputs. States a loop does not use add zeros.
using ClosedLoopPoles = std::array<std::complex<double>, 6>;

/// Closed-loop poles of `model` under `gains`, xi inside, the valve current acting delay_ticks (0..2) periods late,
/// whatever delay the gains were designed for. A load without a spring shows its free position as a pole at one.
/// NaN when model or gains are not finite or the delay is out of range.
ClosedLoopPoles closed_loop_poles(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

/// Largest modulus of the closed-loop poles; below one is stable. For the compliant form the position is left out:
/// it is not controlled, and for a load without a spring it drifts, which is what the form is for.
double closed_loop_spectral_radius(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

}  // namespace farrier::control
