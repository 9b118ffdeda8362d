#pragma once

#include "control/law/force_controller.hpp"
#include "plant/actuator.hpp"
#include "plant/joint_physics.hpp"

namespace farrier::control {

/// Which controller turns a force reference into a valve current.
enum class Kind {
  kLqr,                    ///< ForceController with gains that come over the bus
  kFeedbackLinearisation,  ///< FeedbackLinearisation with gains from the robot file, physics from the bus
  kPid,                    ///< Pid with gains from the robot file
  kFlowInversion,          ///< FlowInversion with physics from the bus
};

/// True for controllers that invert the flow law, with physics from the bus.
constexpr bool takes_physics(Kind kind) noexcept {
  return kind == Kind::kFeedbackLinearisation || kind == Kind::kFlowInversion;
}

/// Tuning of the controller. The defaults are for 1 kHz without delay; their origin:
/// docs/decisions/0015-fixed-baselines.md.
struct FeedbackLinearisationGains {
  double force_1_s = 900.0;             ///< k_p, on the force error; in [0, 1e5]
  double integral_1_s2 = 2e5;           ///< k_i, on its integral; in [0, 1e8]; 0 is off
  double velocity_compensation = 0.95;  ///< compensated share of the piston's displacement flow; in [0, 2]
  double velocity_lead_s = 0.0;         ///< time by which the velocity is led before that; in [0, 0.1]; 0 is off
  double observer_1_s = 0.0;            ///< bandwidth of the disturbance observer; in [0, 1e4]; 0 is off
  double swing_gain = 1.0;              ///< factor on the currents of swing; in [0.1, 10]
};

/// Force controller as HyQ ran it: feedback linearisation with velocity compensation (Boaventura et al. 2012, "On the
/// role of load motion compensation in high-performance force control"; Hubacher 2014, 9.2.5). It inverts the flow law
/// of the given actuator, with the load pressure from the force by (3.19), (3.20). The wanted rate and the rate of the
/// oil are
///   F' = k_p (F_ref - F) + k_i integral(F_ref - F),
///   F' = A_p (K_uv sqrt(drop(u)) u + K_vp v)                        (3.26) with (3.32), (3.33).
/// So u = (F' - A_p K_vp v) / (A_p K_uv sqrt(drop)), where the drop is that of the sign of u. It uses no knowledge of
/// the load or of a delay in the loop, and has one setting for swing and stance. Valve gain and leakage are the
/// actuator's until set_physics() gives others.
///
/// The disturbance observer (Ohnishi 1987; Chen et al. 2016, "Disturbance-observer-based control and related methods")
/// finds the rate of force that the flow law does not explain for the sent current. It is low-passed with the bandwidth w
/// and taken off the wanted rate: d' = w (F' - F'_law - d).
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

  /// Valve gain and leakage between the chambers from the next step on; the oil's compressibility stays, for it only
  /// changes the loop's gain. The current changes by what they differ: the integral is a rate of force and stays.
  /// Returns false and keeps the old ones for physics that no joint has.
  bool set_physics(const plant::JointPhysics& physics) noexcept;

  /// Empties the integral.
  void reset() noexcept;

  /// k_i integral(F_ref - F), N/s or Nm/s.
  double integrator() const noexcept { return integral_; }

 private:
  /// Takes the velocity forward by the lead, with its derivative over twice the lead.
  Measurement led(const Measurement& measurement) noexcept;
  /// Root of the pressure drop of the sign of `current_sign`, sqrt(Pa).
  double drop_root(double current_sign, const Measurement& measurement) const noexcept;
  double leakage_flow(double current_sign, const Measurement& measurement) const noexcept;
  double current_for(double force_rate, const Measurement& measurement) const noexcept;
  void observe(double force) noexcept;
  /// -K_vp of (3.32), N/m over A_p: the oil's stiffness per area.
  double stiffness_per_area(double position) const noexcept;

  plant::ActuatorParams actuator_;
  FeedbackLinearisationGains gains_;
  double operating_position_;
  double period_s_;
  double alpha_;       ///< area_b / area_a
  double valve_gain_;  ///< K_v / sqrt(1 + alpha^3): (3.33) without the compliance
  double leakage_ = 0.0;
  double integral_ = 0.0;
  double slow_velocity_ = 0.0;  ///< the velocity, smoothed over twice the lead
  double disturbance_ = 0.0;    ///< rate of force that the law does not explain, N/s or Nm/s
  double observer_state_ = 0.0;
  double law_rate_ = 0.0;  ///< F' of the law for the last current
  bool has_run_ = false;
};

}  // namespace farrier::control
