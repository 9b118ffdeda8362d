#pragma once

#include "control/law/force_controller.hpp"
#include "plant/actuator.hpp"

namespace farrier::control {

/// Which controller turns a force reference into a valve current.
enum class Kind {
  kLqr,                    ///< ForceController with gains that come over the bus
  kFeedbackLinearisation,  ///< FeedbackLinearisation with gains from the robot file
  kPid,                    ///< Pid with gains from the robot file
  kFlowInversion,          ///< FlowInversion with physics from the bus
};

/// Tuning of the controller. The defaults are for 1 kHz without delay; their origin:
/// docs/decisions/0015-fixed-baselines.md.
struct FeedbackLinearisationGains {
  double force_1_s = 900.0;             ///< k_p, on the force error; in [0, 1e5]
  double integral_1_s2 = 2e5;           ///< k_i, on its integral; in [0, 1e8]; 0 is off
  double velocity_compensation = 0.95;  ///< compensated share of the piston's displacement flow; in [0, 2]
  double velocity_lead_s = 0.0;         ///< time by which the velocity is led before that; in [0, 0.1]; 0 is off
};

/// Force controller as HyQ ran it: feedback linearisation with velocity compensation (Boaventura et al. 2012, "On the
/// role of load motion compensation in high-performance force control"; Hubacher 2014, 9.2.5). It inverts the flow law
/// of the given actuator, with the load pressure from the force by (3.19), (3.20). The wanted rate and the rate of the
/// oil are
///   F' = k_p (F_ref - F) + k_i integral(F_ref - F),
///   F' = A_p (K_uv sqrt(drop(u)) u + K_vp v)                        (3.26) with (3.32), (3.33).
/// So u = (F' - A_p K_vp v) / (A_p K_uv sqrt(drop)), where the drop is that of the sign of u. It uses no knowledge of
/// the load or of a delay in the loop, and has one setting for swing and stance.
///
/// Allocation-free, bounded, cannot fail. One call of step per period. The current is within +-valve_current_max_A;
/// while it is there, an error that would push it further out is not summed, and the integral never asks for more than
/// the open valve can do. The first step after construction or reset starts from null current: the integral takes up
/// the difference. A non-finite reference or measurement gives null current for that tick and leaves the integral
/// unchanged.
class FeedbackLinearisation {
 public:
  struct Output {
    double valve_current_A;
    bool saturated;
  };

  /// `actuator` passes plant::validate; `operating_position` (m or rad, from fully retracted) is where the
  /// measurement's position is 0; `period_s` > 0.
  FeedbackLinearisation(const plant::ActuatorParams& actuator, const FeedbackLinearisationGains& gains,
                        double operating_position, double period_s) noexcept;

  /// Force in N or Nm, as the measurement's.
  Output step(double force_reference, const Measurement& measurement) noexcept;

  /// Empties the integral.
  void reset() noexcept;

  /// k_i integral(F_ref - F), N/s or Nm/s.
  double integrator() const noexcept { return integral_; }

 private:
  /// Takes the velocity forward by the lead, with its derivative over twice the lead.
  Measurement led(const Measurement& measurement) noexcept;
  double current_for(double force_rate, const Measurement& measurement) const noexcept;
  /// -K_vp of (3.32), N/m over A_p: the oil's stiffness per area.
  double stiffness_per_area(double position) const noexcept;

  plant::ActuatorParams actuator_;
  FeedbackLinearisationGains gains_;
  double operating_position_;
  double period_s_;
  double alpha_;       ///< area_b / area_a
  double valve_gain_;  ///< K_v / sqrt(1 + alpha^3): (3.33) without the compliance
  double integral_ = 0.0;
  double slow_velocity_ = 0.0;  ///< the velocity, smoothed over twice the lead
  bool has_run_ = false;
};

}  // namespace farrier::control
