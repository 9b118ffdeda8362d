#pragma once

#include <complex>

#include <Eigen/Core>

#include "control/design/lqr.hpp"

namespace farrier::control {

/// Parameters by which the poles of a force loop are placed.
struct PolePlacement {
  double bandwidth_rad_s = 150.0;  ///< of the pair that force and integral share; > 0, below pi / period
  double damping = 0.9;            ///< of that pair; in [0.1, 5]
};

/// Poles the design asks for, z-plane. The first are the pair exp(s T) of s^2 + 2 zeta w s + w^2. The zeros of the
/// sampled transfer from current to force follow, where the load's own modes lie, and zeros for a delay. Zeros on or
/// outside the unit circle are mirrored into it and held at 0.9995 at most; zeros left of the imaginary axis go to the
/// origin. There are as many poles as the form has states with integrator and delay; the rest of the array is zero.
/// Reasons: docs/decisions/0027-pole-placement.md.
std::array<std::complex<double>, 6> wanted_poles(const DiscreteModel& model, const PolePlacement& poles, Form form,
                                                 double period_s) noexcept;

/// Gain k of u = -k x that gives A - b k the N = 2..6 eigenvalues `poles`, complex ones in neighbouring conjugate
/// pairs. Reflections bring (a, b) to controller-Hessenberg form. The row e_N' p(H) over the product of its subdiagonal
/// is then built one factor at a time (Datta 1987, "An algorithm to assign eigenvalues in a Hessenberg matrix: single
/// input case"). Fails with kNotControllable if a subdiagonal is zero to rounding, and with kPolesNotPlaced if an
/// eigenvalue computed afterwards is further than 1e-3 from its pole.
template <int N>
Result<Eigen::Matrix<double, 1, N>, DesignStatus> place_poles(
    const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
    const Eigen::Matrix<std::complex<double>, N, 1>& poles) noexcept;

/// Gains of the same loop as design_lqr's (integrator (7.7), past inputs for a delay, feed-forward), by place_poles().
/// The integral factor is one: xi would move the poles. `period_s` is that of `model`, in (0, 0.1] s. `found`, if not
/// null, receives the poles of the loop, as of design_lqr.
Result<Gains, DesignStatus> design_pole_placement(const DiscreteModel& model, const PolePlacement& poles,
                                                  double feed_forward_factor, const Normalisation& normalisation,
                                                  Form form, int delay_ticks, double period_s,
                                                  SmallSpectrum* found = nullptr) noexcept;

}  // namespace farrier::control
