#pragma once

#include <array>

#include "control/design/lqr.hpp"

namespace farrier::control {

/// Measurements of the joint, SI. Position relative to the operating point of the model (mid-stroke).
struct Measurement {
  double position;  ///< m
  double velocity;  ///< m/s
  double force;     ///< N, load cell
};

/// Run-time force controller of Fig. 7.1. Allocation-free, bounded, cannot fail. One call of step per period.
///
/// The reference vector is (0, 0, F_ref) as in 9.2.4. Anti-reset windup is conditional integration: while the valve
/// current is saturated, an error that would push it further out is not summed; one that leads back is.
/// Until gains are set the current is null. A non-finite reference or measurement gives null current for that tick
/// and leaves the sum as it was.
class ForceController {
 public:
  struct Output {
    double valve_current_A;  ///< within +-current_A of the normalisation, the probe included
    bool saturated;
    // Contributions before saturation and probe, A; the delay part comes from the past inputs.
    double position_part_A;
    double velocity_part_A;
    double force_part_A;
    double integral_part_A;
    double feed_forward_part_A;
    double delay_part_A;
  };

  /// Changes gains without a bump: the sum is set so that at this measurement and reference the next step repeats the
  /// command of the last step, both without their probe. With the arguments of the last step, changes since then pass
  /// through the new gains; with those of the next step, such a change is lost. The first gains after construction or
  /// reset start with an empty sum. Returns false and keeps the old gains if gains, reference or measurement are not
  /// finite, or the gains have no integral action.
  bool set_gains(const Gains& gains, const Measurement& now, double force_reference) noexcept;

  /// force_reference in N. probe_A is added to the command before it is limited (dither, to identify by); delay
  /// compensation takes it into account like any current that went to the valve.
  Output step(double force_reference, const Measurement& measurement, double probe_A = 0.0) noexcept;

  /// Empties the sum and forgets past currents; the gains stay.
  void reset() noexcept;

  /// Normalised sum of force errors.
  double integrator() const noexcept { return sum_; }

 private:
  Output contributions(const Gains& gains, double force_reference, const Measurement& measurement) const noexcept;
  void remember(double valve_current_A) noexcept;

  Gains gains_{};
  bool has_gains_ = false;
  bool has_run_ = false;
  double sum_ = 0.0;
  double command_A_ = 0.0;  // of the last step, limited, without the probe
  std::array<double, kMaxDelayTicks> past_currents_A_{};  // newest first
};

}  // namespace farrier::control
