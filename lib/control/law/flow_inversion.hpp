#pragma once

#include <array>

#include "control/law/flow_model.hpp"
#include "control/law/force_controller.hpp"

namespace farrier::control {

/// Tuning of the controller, for a period of 1 ms. Origin of the defaults: docs/decisions/0029-flow-inversion.md.
struct FlowInversionGains {
  double error_share = 0.9;       ///< of the force error, removed within a tick; in (0, 1]
  double reference_share = 1.0;   ///< of the command's last change, expected again; in [0, 1], 0 is off
  // Shares of the difference between measurement and prediction, in [0, 1]; the first two above zero:
  double force_share = 0.7;       ///< into the predicted force
  double velocity_share = 0.3;    ///< into the predicted velocity
  double flow_share = 0.3;        ///< of the force, into an unexplained rate of force (integral action)
  double load_share = 0.03;       ///< of the velocity, into a force on the load
};

/// Force that is wanted, and its dependence on the motion: an outer loop of stiffness and damping moves its reference
/// within the tick that it takes to get there.
struct ForceReference {
  // NOLINTNEXTLINE(google-explicit-constructor): a force alone is a reference
  ForceReference(double force_, double stiffness_ = 0.0, double damping_ = 0.0) noexcept
      : force(force_), stiffness(stiffness_), damping(damping_) {}

  double force;      ///< for the position and velocity just measured, N or Nm
  double stiffness;  ///< -dF/dx, N/m or Nm/rad; >= 0
  double damping;    ///< -dF/dv, Ns/m or Nms/rad; >= 0
};

/// Force controller that inverts the flow law over one tick. It runs FlowModel with the currents it sent and corrects
/// state and two disturbances by the measurement: a fixed-gain observer of position, velocity, both chamber pressures,
/// flow and load. It predicts over the loop's delay and finds the current for which
///   F = F_ref(x, v) + (1 - error_share) (F - F_ref)
/// holds at the end of the tick. F_ref is affine in position and velocity at that end. Its commanded part is assumed to
/// change as it did last: feed-forward from the commands' derivative, without the motion's noise in it. The prediction
/// includes the flow that the piston's motion takes and the load's effect on the force within the tick. The disturbance
/// of flow is the integral action; saturation does not wind it up, as the model knows the sent current. Derivation and
/// measurements: docs/derivations/flow-inversion.md.
///
/// Allocation-free, bounded (at most 7 + delay_ticks runs of FlowModel::advance), cannot fail. One call of step per
/// period. Null current before set_physics. A non-finite reference or measurement gives null current for that tick,
/// which the model takes into account; a non-finite prediction restarts it.
class FlowInversion {
 public:
  struct Output {
    double valve_current_A;  ///< within +-valve_current_max_A, the probe included
    bool saturated;
  };

  /// `actuator` passes plant::validate; `operating_position` (m or rad, from fully retracted) is where the
  /// measurement's position is 0, `slack_position` where the load's spring is slack; `period_s` > 0;
  /// `delay_ticks` in 0..kMaxDelayTicks.
  FlowInversion(const plant::ActuatorParams& actuator, const FlowInversionGains& gains, double operating_position,
                double slack_position, double period_s, int delay_ticks) noexcept;

  /// Physics from the next step on. Bumpless: the force in the model stays, and so does the sum of bias force and the
  /// disturbance found beside it, which the observer knows better than a later estimate. Returns false and keeps the
  /// old physics for values that are not finite or out of the ranges of JointPhysics, and for a load without mass.
  bool set_physics(const plant::JointPhysics& physics) noexcept;

  /// Force in N or Nm, as the measurement's. probe_A is added to the current before it is limited.
  Output step(const ForceReference& reference, const Measurement& measurement, double probe_A = 0.0) noexcept;

  /// Forgets state, disturbances and past currents; physics stays.
  void reset() noexcept;

  const FlowModel::Disturbance& disturbance() const noexcept { return disturbance_; }

 private:
  /// force + stiffness (x_0 - x) + damping (v_0 - v): force wanted at position x and velocity v.
  struct Line {
    double force, stiffness, damping, position, velocity;
    double at(const plant::State& s) const noexcept {
      return force + stiffness * (position - s.position) + damping * (velocity - s.velocity);
    }
  };

  void begin(const Measurement& measurement) noexcept;
  void correct(const Measurement& measurement) noexcept;
  double current_for(const plant::State& state, const Line& wanted) const noexcept;
  Output send(double wanted_A) noexcept;

  plant::ActuatorParams actuator_;
  FlowInversionGains gains_;
  double operating_position_;
  double slack_position_;
  double period_s_;
  std::size_t delay_ticks_;
  double most_force_;
  FlowModel model_;
  double bias_force_ = 0.0;  ///< of the physics
  bool has_physics_ = false;
  bool has_run_ = false;
  bool has_last_ = false;
  plant::State state_{};  ///< of the last tick, then of this one
  FlowModel::Disturbance disturbance_{};
  Line last_{};  ///< of the last tick
  std::array<double, kMaxDelayTicks + 1> sent_A_{};  ///< newest first
};

}  // namespace farrier::control
