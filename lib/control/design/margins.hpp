#pragma once

#include <cmath>
#include <complex>

#include "control/design/lqr.hpp"
#include "control/design/measurement_filter.hpp"

namespace farrier::control {

/// Distance of a loop from instability when the input f(z) u acts on the plant instead of u; f = 1 nominally. All
/// margins are zero for a loop that is unstable at f = 1, or not finite.
struct Margins {
  /// Balanced disk margin (Seiler, Packard and Gahinet 2020, "An introduction to disk margins", sigma = 0):
  /// alpha = 1 / max |(S - T) / 2|, in [0, 2]. Every f inside the disk through (2 - alpha) / (2 + alpha) and its
  /// inverse on the real axis, dynamic ones included, leaves the loop stable.
  double disk = 0.0;
  double disk_angle_rad = 0.0;  ///< per tick: frequency where the loop is nearest to it
  double gain_up = 0.0;         ///< smallest factor above one that destabilises it; infinite when none does
  double gain_down = 0.0;       ///< largest below one; zero when none does
  double phase_rad = 0.0;       ///< smallest lag or lead that destabilises it; pi when none does
  /// Smallest additional delay that destabilises it; infinite when none does. Behind filters it is that of a current
  /// which is held between ticks; without, a pure one, from which a held one may differ by a fifth.
  double delay_ticks = 0.0;

  /// Gain factors up to this are inside the disk: (2 + alpha) / (2 - alpha).
  double disk_gain() const noexcept { return disk < 2.0 ? (2.0 + disk) / (2.0 - disk) : 1e300; }
  /// Phase within the disk, 2 atan(alpha / 2).
  double disk_phase_rad() const noexcept { return 2.0 * std::atan(0.5 * disk); }
};

/// The loop of `gains` around `model`, broken where the current leaves the controller, delay_ticks (0..2) late: the
/// returned signal, negative feedback, for exp(i angle_rad) sent. The compliant form leaves the position out.
std::complex<double> loop_gain(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                               const MeasurementFilters& filters, double angle_rad) noexcept;

/// Margins of that loop over 0.001 rad per tick to pi: a grid of 32 angles, evenly in their logarithm, with refinement
/// around the lows of the disk margin and at every crossing. The disk margin is within 1 % of a grid of 20000 on the
/// loops of shipped robots (control_margins_test). A resonance narrower than the grid can hide, so the angles of the
/// closed loop's poles are evaluated as well.
Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks,
                const MeasurementFilters& filters = {}) noexcept;

/// The same for a caller that knows closed_loop_spectrum() of this loop.
Margins margins(const DiscreteModel& model, const Gains& gains, int delay_ticks, const MeasurementFilters& filters,
                const SmallSpectrum& poles) noexcept;

}  // namespace farrier::control
