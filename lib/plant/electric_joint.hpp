#pragma once

#include "core/result.hpp"
#include "plant/adaptive_steps.hpp"
#include "plant/electric_actuator.hpp"
#include "plant/motion.hpp"

namespace farrier::plant {

/// Nonlinear electric joint (electric_actuator.hpp), advanced one control period at a time. Invariants: friction,
/// winding, spring damping and stops only dissipate, every value stays finite. Results do not depend on the machine:
/// +, -, *, / and sqrt only.
class ElectricJoint {
 public:
  /// Local error a substep may make: sum over the states, relative to travel, no-load speed, the spring's deflection
  /// under the stall torque, and the largest current.
  static constexpr double kDefaultTolerance = 1e-6;
  /// Periods up to this are stepped.
  static constexpr double kLongestPeriod_s = 0.1;

  /// Refuses non-physical values, naming each, a load with dry friction, and models with a rate too fast for
  /// kShortestSubstep_s. `tolerance` in [1e-14, 1e-2].
  static Result<ElectricJoint> create(const ElectricParams& actuator, const LoadParams& load,
                                      const ElectricState& initial, double tolerance = kDefaultTolerance);

  /// Another load from now on: the state is continuous. False, and the old load kept, for values create() would refuse.
  bool set_load(const LoadParams& load) noexcept;

  /// Advances by `period_s` with both inputs held. The command acts within +-current_max_A(), the external force (on
  /// the load, positive along +position, Nm) within 10 stall torques. Inputs that are not finite act as zero; a period
  /// outside (0, kLongestPeriod_s] moves nothing.
  StepReport step(double command_A, double external_force, double period_s) noexcept;

  /// Advances by `period_s` while a mechanism moves the load to `end`, at a constant velocity and whatever the torque that
  /// it needs, as HydraulicJoint::follow. Adds to `account`.
  StepReport follow(double command_A, const Motion& end, double period_s, ElectricAccount& account) noexcept;
  /// Torque on the mechanism, Nm: that of the spring, or of a rigid drive less its friction, and of the end stops. The
  /// mechanism has the inertia of a rigid drive's rotor.
  double mechanism_force() const noexcept { return equations_.mechanism_torque(state_); }

  const ElectricState& state() const noexcept { return state_; }
  /// T, what the torque sensor reads or a rigid drive knows from its current, Nm.
  double load_cell_force() const noexcept { return equations_.sensed_torque(state_); }

  const ElectricParams& actuator() const noexcept { return equations_.actuator(); }
  const LoadParams& load() const noexcept { return equations_.load(); }

 private:
  ElectricJoint(const ElectricParams& actuator, const LoadParams& load, const ElectricState& initial, double tolerance);

  double admit(double command_A, StepReport& report) const noexcept;
  double advance(const ElectricEquations::Input& input, double period_s, StepReport& report,
                 ElectricAccount* account = nullptr) noexcept;
  double error_ratio(const ElectricState& error) const noexcept;

  ElectricEquations equations_;
  ElectricState state_;
  double substep_s_ = 2.5e-4;
  double command_limit_A_;
  double external_force_limit_;
  ElectricState inverse_tolerance_;
};

}  // namespace farrier::plant
