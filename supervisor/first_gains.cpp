#include "supervisor/first_gains.hpp"

#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"
#include "supervisor/joint_design.hpp"

namespace farrier::supervisor {
namespace {

bool is_filtered(const robot::Joint& joint, double period_s) noexcept {
  return !robot::measurement_filters(joint, period_s).are_wires();
}

}  // namespace

Result<SlotGains> design_slots(const robot::Joint& joint, Design design, double period_s, int delay_ticks) {
  SlotGains slots;
  const bool by_phase = design == Design::kPhases || (design == Design::kAdaptive && is_filtered(joint, period_s));
  for (const signals::Phase phase : kPhases) {
    const bool for_stance = design == Design::kStance || (by_phase && phase == signals::Phase::kStance);
    const auto gains =
        FARRIER_TRY(design_joint(joint, for_stance ? joint.stance_load : joint.swing_load, period_s, delay_ticks));
    slots[static_cast<std::size_t>(phase)] = gains;
  }
  return slots;
}

std::vector<plant::LoadParams> loads_to_hold(const robot::Robot& robot, const robot::Joint& joint,
                                             signals::Phase phase) {
  if (!is_filtered(joint, robot.period_s) && !robot.on_ground) {
    return {};
  }
  if (robot.plan.gait.pattern == gait::Pattern::kStand) {
    return {joint.swing_load, joint.stance_load};
  }
  return {phase == signals::Phase::kStance ? joint.stance_load : joint.swing_load};
}

plant::JointPhysics first_physics(const robot::Joint& joint, Design design, signals::Phase phase) noexcept {
  const bool stance = phase == signals::Phase::kStance;
  const bool for_stance = design == Design::kStance || (stance && design != Design::kSwing);
  plant::JointPhysics physics = robot::nominal_physics(joint, for_stance ? joint.stance_load : joint.swing_load);
  if (design == Design::kAdaptive && joint.estimator.finds_valve()) {
    // An unknown valve is taken for a strong one: a law for a weaker valve than there is may be unstable.
    physics.valve_gain *= 1.0 + joint.estimator.valve_flow.value_or(estimation::ValveFlowParams{}).gain_uncertainty;
  }
  if (joint.kind == control::Kind::kFeedbackLinearisation) {
    physics.leakage = 0.0;  // its gains are tuned on what the lands of the valve leak
    physics.valve_gain /= stance ? 1.0 : joint.feedback_linearisation.swing_gain;
  }
  return physics;
}

Result<Done> check_first(const robot::Robot& robot, const std::vector<SlotGains>& first_gains, int delay_ticks) {
  if (first_gains.empty()) {
    return Done{};
  }
  if (first_gains.size() != robot.joints.size()) {
    return Error{"first gains of " + std::to_string(first_gains.size()) + " joints, but " + robot.name + " has " +
                 std::to_string(robot.joints.size()) + ": give every joint's"};
  }
  for (const robot::Joint& joint : robot.joints) {
    for (const control::Gains& gains : first_gains[joint.number]) {
      if (gains.delay_ticks != delay_ticks) {
        return Error{joint.name + ": first gains for a delay of " + std::to_string(gains.delay_ticks) +
                     " ticks in a loop with " + std::to_string(delay_ticks) + ": give gains designed for that"};
      }
    }
  }
  return Done{};
}

}  // namespace farrier::supervisor
