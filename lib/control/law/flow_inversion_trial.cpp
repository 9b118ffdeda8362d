#include "control/law/flow_inversion_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farrier::control {

double trial_error(const FlowInversionTrial& t, const plant::JointPhysics& told,
                   const plant::JointPhysics& actual) noexcept {
  const FlowModel joint(t.actuator, actual, t.slack_position, t.period_s);
  constexpr FlowModel::Disturbance kNone{};
  plant::State state = plant::equilibrium(t.actuator, {.mass = 1.0}, t.position, 0.0);
  joint.set_force(state, 0.0, kNone);
  FlowInversion controller(t.actuator, t.gains, t.position, t.slack_position, t.period_s, t.delay_ticks);
  if (!controller.set_physics(told)) {
    return std::numeric_limits<double>::infinity();
  }
  std::array<double, kMaxDelayTicks + 1> sent_A{};
  const auto delay = static_cast<std::size_t>(std::clamp(t.delay_ticks, 0, kMaxDelayTicks));
  double squares = 0.0;
  for (int tick = 0; tick < kTrialTicks; ++tick) {
    const Measurement measured{state.position - t.position, state.velocity, joint.load_cell_force(state, kNone)};
    const double error = measured.force - t.force_step;
    squares += tick >= kTrialTicks - kTrialJudgedTicks ? error * error : 0.0;
    std::shift_right(sent_A.begin(), sent_A.end(), 1);
    sent_A[0] = controller.step(t.force_step, measured).valve_current_A;
    state = joint.advance(state, sent_A[delay], kNone);
  }
  const double ratio = std::sqrt(squares / kTrialJudgedTicks) / t.force_step;
  return std::isfinite(ratio) ? ratio : std::numeric_limits<double>::infinity();
}

}  // namespace farrier::control
