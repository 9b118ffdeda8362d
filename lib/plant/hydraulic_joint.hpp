#pragma once

#include <optional>
#include <span>

#include "core/result.hpp"
#include "plant/actuator.hpp"
#include "plant/adaptive_steps.hpp"
#include "plant/effects/delay_line.hpp"
#include "plant/effects/lean_equations.hpp"
#include "plant/equations.hpp"
#include "plant/motion.hpp"
#include "plant/oil_account.hpp"
#include "plant/step_report.hpp"
#include "plant/terms/valve_hysteresis.hpp"

namespace farrier::plant {

/// Present values of a joint's effects; without effects those of (2.30).
struct EffectReadings {
  double opening_A = 0.0;           ///< current the valve is open for, after hysteresis, spool and deadband
  double line_pressure_a_Pa = 0.0;  ///< behind the valve; the chamber's without lines
  double line_pressure_b_Pa = 0.0;
  double line_flow_a_m3_s = 0.0;  ///< into the chamber through its line; 0 without lines
  double line_flow_b_m3_s = 0.0;
  double friction = 0.0;      ///< dry friction on the load, N or Nm
  double piston_force = 0.0;  ///< of effects left of the load cell, on the piston; N or Nm
};

/// Nonlinear hydraulic joint: four-way valve, actuator, load (Hubacher 2014, (2.30a), (2.30b)) and the effects of
/// plant/effects that its parameters ask for or that it is created with, advanced one control period at a time.
/// Invariants: shut valve conserves fluid, damping and stops only dissipate, pressures are never negative, every value
/// stays finite. Results do not depend on the machine: +, -, *, / and sqrt only.
class HydraulicJoint {
 public:
  /// Largest local error of a substep: sum over the states, relative to stroke, velocity_scale(), supply pressure.
  static constexpr double kDefaultTolerance = 1e-6;
  static constexpr double kShortestSubstep_s = plant::kShortestSubstep_s;
  /// Periods up to this are stepped.
  static constexpr double kLongestPeriod_s = 0.1;

  /// Refuses non-physical values, naming each, and models with a rate too fast for kShortestSubstep_s. The `tolerance`
  /// is in [1e-14, 1e-2]. The joint uses those `effects` left and right of the load cell, except those of is_in_load():
  /// loads_with_effects() puts them into loads. Effects of sensors belong to the sensors.
  static Result<HydraulicJoint> create(const ActuatorParams& actuator, const LoadParams& load, const State& initial,
                                       double tolerance = kDefaultTolerance,
                                       std::span<const ActiveEffect> effects = {});

  /// Sets another load from now on: position, velocity and pressures are continuous, and the friction and the share of
  /// mass on a spring stay if they are effects. Returns false and keeps the old load for values create() would refuse.
  bool set_load(const LoadParams& load) noexcept;

  /// Sets another valve, oil, piston and effects from now on: motion, pressures and the states of effects are
  /// continuous. Areas, stroke, lines and the effects of the load are not changed. Returns false and keeps the old ones
  /// for values create() would refuse.
  bool set_actuator(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept;

  /// Advances by `period_s` with both inputs held. The current acts within +-valve_current_max_A, the external force
  /// (on the load, positive along +position, N or Nm) within 10 supply_pressure_Pa area. Inputs that are not finite
  /// act as zero; a period outside (0, kLongestPeriod_s] moves nothing.
  StepReport step(double valve_current_A, double external_force, double period_s) noexcept;

  /// Advances by `period_s` while a mechanism moves the piston to `end`, at a constant velocity and whatever the force
  /// that it needs: the half of the joint left of the load cell. The current is held, and so is the pressure of the
  /// supply in place of the nominal one (Pa, finite and >= 0, else the nominal one acts). Adds to `account`. The load,
  /// with a part on a spring, and external forces no longer act; set_load() ends that. An end that is not finite moves nothing.
  StepReport follow(double valve_current_A, double supply_pressure_Pa, const Motion& end, double period_s,
                    OilAccount& account) noexcept;

  const State& state() const noexcept { return state_; }
  /// F_s = F_h + F_stop - d_p v - m_p a, (2.22) left side, and effects on the piston, with the last input; N or Nm.
  double load_cell_force() const noexcept;
  /// Force on a mechanism that has the piston's mass in it, as follow() wants it: load_cell_force() + m_p a, with
  /// effects on the load; N or Nm.
  double mechanism_force() const noexcept;
  /// Energy that the oil of both chambers stores, V p^2 / (2 beta_e) each; J.
  double stored_J() const noexcept;
  /// F_h = A_p (p_a - alpha p_b), (2.8); N or Nm.
  double hydraulic_force() const noexcept { return equations_.hydraulic_force(integrated_); }
  /// With the last input; m/s^2 or rad/s^2.
  double acceleration() const noexcept { return derivative_.velocity; }
  /// Space of each chamber with its line that holds no oil; 0 unless cavitated.
  double void_volume_a_m3() const noexcept;
  double void_volume_b_m3() const noexcept;
  /// With the last input.
  EffectReadings effects() const noexcept;

  const ActuatorParams& actuator() const noexcept { return actuator_; }
  const LoadParams& load() const noexcept { return equations_.load(); }

 private:
  HydraulicJoint(const ActuatorParams& actuator, const LoadParams& load, const State& initial, double tolerance,
                 std::span<const ActiveEffect> effects);

  CommandInput admit(double valve_current_A, double external_force, StepReport& report) const noexcept;
  void report_errors(double relative_error, StepReport& report) const noexcept;
  /// A current that now acts, after the valve's hysteresis.
  double through_hysteresis(double current_A) noexcept;
  /// An input as it reaches the spool; unchanged if it waits in the delay.
  CommandInput at_spool(CommandInput input) noexcept;
  void find_lean() noexcept;
  void hold(const CommandInput& input) noexcept;
  using AllState = EffectState<Effects>;
  using LeanState = EffectState<LeanEffects>;
  EquationsWithEffects<Effects> with_effects() const noexcept { return {equations_, effects_}; }
  EquationsWithEffects<LeanEffects, OpeningInput> with_lean_effects() const noexcept { return {equations_, *lean_}; }
  static LeanState lean_state(const AllState& s) noexcept { return {s, LeanEffects::out_of<Effects>(s.x)}; }
  static void take(const LeanState& s, AllState& all) noexcept {
    static_cast<IntegrationState&>(all) = s;
    LeanEffects::put_into<Effects>(all.x, s.x);
  }
  void differentiate() noexcept;
  /// Advance by a period with the held input, or with the currents that leave the delay in it; relative error.
  double advance(double period_s, StepReport& report, OilAccount* account = nullptr) noexcept;
  double advance_delayed(double period_s, StepReport& report, OilAccount* account = nullptr) noexcept;
  template <class Equations, class EquationState>
  double integrate(const Equations& equations, const typename Equations::Input& input, EquationState& state,
                   EquationState& derivative, double period_s, StepReport& report, OilAccount* account) noexcept;
  /// Errors of a trial step relative to their tolerances, added up; not <= 1 when the trial must be repeated.
  double error_ratio(const IntegrationState& error) const noexcept;
  template <class Set>
  double error_ratio(const EffectState<Set>& error) const noexcept;
  template <class Set>
  typename Set::X inverse_tolerance_of(const EffectState<Set>&) const noexcept {
    return Set::template out_of<Effects>(inverse_tolerance_effects_);
  }
  double effects_piston_force() const noexcept;
  double effects_load_force() const noexcept;
  void publish_state() noexcept;

  double tolerance_;
  ActuatorParams actuator_;
  JointEquations equations_;  ///< of chambers without the volume of their lines behind the valve
  Effects effects_;
  bool has_effects_;
  std::optional<LeanEffects> lean_;  ///< the same effects, where they are lean
  std::optional<SlidingEffects> sliding_;
  DelayLine delay_;
  std::optional<ValveHysteresis<double>> hysteresis_;  ///< exact for the currents that are held
  std::optional<FrictionParams> guide_;                ///< of an effect: replaces the load's own
  std::optional<FlexibleParams> part_;                 ///< likewise
  AllState integrated_;
  CommandInput command_{0.0, 0.0};  ///< after delay and hysteresis
  HeldInput input_;
  OpeningInput lean_input_;
  AllState derivative_;
  State state_;
  double substep_s_ = 2.5e-4;
  double external_force_limit_;
  double inverse_tolerance_position_;
  double inverse_tolerance_velocity_;
  double inverse_tolerance_pressure_;
  Effects::X inverse_tolerance_effects_;
};

}  // namespace farrier::plant
