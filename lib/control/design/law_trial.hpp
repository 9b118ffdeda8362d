#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "control/design/measurement_filter.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/flow_model.hpp"

namespace farrier::control {

/// Conditions of a trial of a loop: the commanded force steps, on a joint that is at rest without force. An outer loop
/// of stiffness and damping about the place of rest makes the reference of it, as a joint's node does.
struct LawTrial {
  const plant::ActuatorParams& actuator;  ///< passes plant::validate
  double position;                        ///< at the start; m or rad from fully retracted
  double slack_position;                  ///< of the load's spring, likewise
  double force_step;                      ///< of the command, from the first tick on, N or Nm; > 0
  double outer_stiffness;                 ///< N/m or Nm/rad; >= 0
  double outer_damping;                   ///< Ns/m or Nms/rad; >= 0
  double period_s;
  int delay_ticks;
  const MeasurementFilters& sensors;  ///< between the joint and the outer loop
  const MeasurementFilters& filters;  ///< between the joint and the law
  int ticks;                          ///< >= kTrialJudgedTicks
};

inline constexpr int kTrialJudgedTicks = 10;  ///< the last of a trial

/// RMS force error over the last kTrialJudgedTicks ticks of the trial, over the step. The joint has the physics `actual`
/// (in the ranges of JointPhysics). `law(reference, measured)` gives a tick's current, A. The result is below 1 for a
/// loop that settles. It is of the order of the actuator's force over the step for one that oscillates between its
/// limits. Infinite if the motion is not finite. Allocates nothing if the law does not.
template <class Law>
double trial_error(const LawTrial& t, const plant::JointPhysics& actual, Law&& law) noexcept {
  const FlowModel joint(t.actuator, actual, t.slack_position, t.period_s);
  constexpr FlowModel::Disturbance kNone{};
  plant::State state = plant::equilibrium(t.actuator, {.mass = 1.0}, t.position, 0.0);
  joint.set_force(state, 0.0, kNone);
  RunningFilter position(t.filters.position), velocity(t.filters.velocity), force(t.filters.force);
  RunningFilter felt_position(t.sensors.position), felt_velocity(t.sensors.velocity);
  const auto wanted = [&t](double x, double v) { return t.force_step - t.outer_stiffness * x - t.outer_damping * v; };
  std::array<double, kMaxDelayTicks + 1> sent_A{};
  const auto delay = static_cast<std::size_t>(std::clamp(t.delay_ticks, 0, kMaxDelayTicks));
  double squares = 0.0;
  for (int tick = 0; tick < t.ticks; ++tick) {
    const double x = state.position - t.position;
    const double truth = joint.load_cell_force(state, kNone);
    const double error = truth - wanted(x, state.velocity);
    squares += tick >= t.ticks - kTrialJudgedTicks ? error * error : 0.0;
    const ForceReference reference(wanted(felt_position.take(x), felt_velocity.take(state.velocity)), t.outer_stiffness,
                                   t.outer_damping);
    std::shift_right(sent_A.begin(), sent_A.end(), 1);
    sent_A[0] = law(reference, Measurement{position.take(x), velocity.take(state.velocity), force.take(truth)});
    state = joint.advance(state, sent_A[delay], kNone);
  }
  const double ratio = std::sqrt(squares / kTrialJudgedTicks) / t.force_step;
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

}  // namespace farrier::control
