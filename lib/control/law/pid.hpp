#pragma once

#include "control/law/force_controller.hpp"

namespace farrier::control {

/// Gains of a PID on the normalised force error e: current over its limit per force over Normalisation::force, so that
/// one setting serves cylinders and rotary motors. Origin of the defaults: docs/decisions/0028-pid.md.
struct PidGains {
  double proportional = 0.9;           ///< >= 0
  double integral_1_s = 450.0;         ///< on the integral of e; >= 0, 0 is off
  double derivative_s = 0.0;           ///< on the filtered derivative of e; >= 0
  double derivative_filter_Hz = 200.0; ///< corner of the first-order filter on that derivative; > 0
};

/// Fixed-gain force controller, as laboratories with HyQ run it: u / V = k_p e + k_i int e + k_d s / (1 + s / w_f) e
/// (Astrom and Hagglund 1995, "PID controllers", ch. 3). The filter is sampled exactly for an error held over each
/// period. It uses no knowledge of load, oil, delay or phase.
///
/// Allocation-free, bounded, cannot fail. One call of step per period. The current is within +-Normalisation::current_A;
/// while it is there, an error that would push it further out is not summed, and the integral alone never asks for
/// more than the limit. The first step after construction or reset starts with an empty integral and derivative.
/// A non-finite reference or measurement gives null current for that tick and leaves integral and filter as they were.
class Pid {
 public:
  struct Output {
    double valve_current_A;
    bool saturated;
  };

  /// All of `normalisation` positive and finite, `period_s` > 0.
  Pid(const PidGains& gains, const Normalisation& normalisation, double period_s) noexcept;

  /// Force in N or Nm, as the measurement's.
  Output step(double force_reference, const Measurement& measurement) noexcept;

  /// Empties integral and derivative.
  void reset() noexcept;

  /// Integral part, over the limit of the current; within +-1.
  double integrator() const noexcept { return integral_; }

 private:
  PidGains gains_;
  Normalisation normalisation_;
  double period_s_;
  double filter_keeps_;  ///< exp(-w_f T)
  double integral_ = 0.0;
  double last_error_ = 0.0;
  double rate_1_s_ = 0.0;  ///< filtered derivative of the error
  bool has_run_ = false;
};

}  // namespace farrier::control
