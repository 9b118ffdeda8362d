#pragma once

#include "core/result.hpp"
#include "plant/actuator.hpp"
#include "plant/equations.hpp"

namespace farrier::plant {

struct TrialStep;

/// What one step did. The error is that of the whole state: local errors of the fourth-order solution (the fifth is
/// kept), relative to stroke, velocity_scale() and supply pressure, added over states and substeps, and given in each
/// unit. States are coupled, so that one whose own estimate vanishes by chance still errs by its neighbours'. Substeps
/// striding over a void's start or a port's laminar range count 30 times. Measured on HyQ cylinders against a 2 us
/// reference: the true error of a step is typically a twentieth of this, below it in over 99.5 % of steps, and at
/// most 6 times it (a substep that grazes a void between its stages).
struct StepReport {
  double error_position = 0.0;     ///< m or rad
  double error_velocity = 0.0;     ///< m/s or rad/s
  double error_pressure_Pa = 0.0;  ///< either chamber
  int substeps = 0;                ///< accepted ones; at most 2 period / kShortestSubstep_s
  int rejected = 0;                ///< substeps tried and repeated smaller
  bool bound_hit = false;          ///< a substep was taken above tolerance, being the shortest allowed
  bool cavitated = false;          ///< a chamber held a void
  bool at_stop = false;            ///< the piston pressed on an end stop
  bool input_refused = false;      ///< an input was not finite or out of range and its substitute acted
};

/// Nonlinear hydraulic joint: four-way valve, actuator, load (Hubacher 2014, (2.30a), (2.30b)), advanced one control
/// period at a time. Invariants: shut valve conserves fluid, damping and stops only dissipate, pressures are never
/// negative, every value stays finite. Results do not depend on the machine: +, -, *, / and sqrt only.
class HydraulicJoint {
 public:
  /// Local error a substep may make: sum over the states, relative to stroke, velocity_scale(), supply pressure.
  static constexpr double kDefaultTolerance = 1e-6;
  /// Substeps are never asked to be shorter than this.
  static constexpr double kShortestSubstep_s = 1e-5;
  /// Periods up to this are stepped.
  static constexpr double kLongestPeriod_s = 0.1;

  /// Refuses non-physical values, naming each, and models with a rate too fast for kShortestSubstep_s.
  /// `tolerance` in [1e-14, 1e-2].
  static Result<HydraulicJoint> create(const ActuatorParams& actuator, const LoadParams& load, const State& initial,
                                       double tolerance = kDefaultTolerance);

  /// Another load from now on: position, velocity and pressures are continuous. False, and the old load kept, for
  /// values create() would refuse.
  bool set_load(const LoadParams& load) noexcept;

  /// Advances by `period_s` with both inputs held. The current acts within +-valve_current_max_A, the external force
  /// (on the load, positive along +position, N or Nm) within 10 supply_pressure_Pa area. Inputs that are not finite
  /// act as zero; a period outside (0, kLongestPeriod_s] moves nothing.
  StepReport step(double valve_current_A, double external_force, double period_s) noexcept;

  const State& state() const noexcept { return state_; }
  /// F_s = F_h + F_stop - d_p v - m_p a, (2.22) left side, with the last input; N or Nm.
  double load_cell_force() const noexcept;
  /// F_h = A_p (p_a - alpha p_b), (2.8); N or Nm.
  double hydraulic_force() const noexcept { return equations_.hydraulic_force(integrated_); }
  /// With the last input; m/s^2 or rad/s^2.
  double acceleration() const noexcept { return derivative_.velocity; }
  /// Space of each chamber that holds no oil; 0 unless cavitated.
  double void_volume_a_m3() const noexcept;
  double void_volume_b_m3() const noexcept;

  const ActuatorParams& actuator() const noexcept { return equations_.actuator(); }
  const LoadParams& load() const noexcept { return equations_.load(); }

 private:
  HydraulicJoint(const JointEquations& equations, const State& initial, double tolerance) noexcept;

  HeldInput admit(double valve_current_A, double external_force, StepReport& report) const noexcept;
  /// Errors of a trial step relative to their tolerances, added up; not <= 1 when the trial must be repeated.
  double error_ratio(const IntegrationState& error) const noexcept;
  bool meets_bend(const TrialStep& trial, double h) const noexcept;
  void publish_state() noexcept;

  JointEquations equations_;
  IntegrationState integrated_;
  HeldInput input_;
  IntegrationState derivative_;
  State state_;
  double substep_s_ = 2.5e-4;
  double external_force_limit_;
  double inverse_tolerance_position_;
  double inverse_tolerance_velocity_;
  double inverse_tolerance_pressure_;
};

}  // namespace farrier::plant
