#pragma once

#include <array>
#include <complex>

#include "control/design/lqr.hpp"
#include "control/numerics/spectrum.hpp"

namespace farrier::control {

/// Poles of a loop: integrator, position, velocity, force and two past inputs. States a loop does not use add zeros.
using ClosedLoopPoles = std::array<std::complex<double>, 6>;

/// Closed-loop poles of `model` under `gains`, xi inside. The valve current acts delay_ticks (0..2) periods late, which
/// may differ from the delay the gains were designed for. A load without a spring shows its free position as a pole at
/// one. NaN if model or gains are not finite or the delay is out of range.
ClosedLoopPoles closed_loop_poles(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

/// Transition of the loop's states, normalised, at zero reference, xi inside. The states are the sum of force errors,
/// position (full-state form only), velocity, force, and as many past inputs, newest first, as delay and gains use.
SmallMatrix closed_loop_matrix(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

/// Eigenvalues of closed_loop_matrix(): the poles of the states that the loop uses.
SmallSpectrum closed_loop_spectrum(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

/// Largest modulus of the closed-loop poles; below one is stable. The compliant form leaves the position out: it is not
/// controlled, and for a load without a spring it drifts by design.
double closed_loop_spectral_radius(const DiscreteModel& model, const Gains& gains, int delay_ticks) noexcept;

}  // namespace farrier::control
