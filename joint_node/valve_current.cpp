// From a force reference to a current: the joint's controller, whichever its file says.

#include <algorithm>

#include "joint_node/joint_node.hpp"

namespace farrier::joint_node {

double JointNode::valve_current(const control::ForceReference& reference, const control::Measurement& measured,
                                double probe_A) noexcept {
  switch (joint_.kind) {
    case control::Kind::kLqr:
      return valve_current_by_gains(reference.force, measured, probe_A);
    case control::Kind::kFeedbackLinearisation: {
      take_valve_physics();
      const control::FeedbackLinearisation::Output output = flow_law_->step(reference.force, measured);
      return probed(output.valve_current_A, output.saturated, probe_A);
    }
    case control::Kind::kPid: {
      const control::Pid::Output output = pid_.step(reference.force, measured);
      return probed(output.valve_current_A, output.saturated, probe_A);
    }
    case control::Kind::kFlowInversion:
      return valve_current_by_physics(reference, measured, probe_A);
  }
  return 0.0;
}

// The law runs on the file's physics until others come. The overlap is compensated behind it.
void JointNode::take_valve_physics() noexcept {
  const Slot& slot = acting_[static_cast<std::size_t>(phase_)];
  const bool changed = slot.issue != controller_issue_ || phase_ != controller_phase_;
  if (slot.issue != 0 && changed && flow_law_->set_physics(slot.physics)) {
    compensation_.set_overlap_A(slot.physics.overlap_A);
    controller_issue_ = slot.issue;
    controller_phase_ = phase_;
  }
}

double JointNode::probed(double asked_A, bool saturated, double probe_A) noexcept {
  const double limit_A = joint_.actuator.valve_current_max_A;
  const double wanted_A = asked_A + probe_A;
  const double current_A = std::clamp(wanted_A, -limit_A, limit_A);
  faults_.set(Fault::kValveSaturated, saturated || current_A != wanted_A);
  return current_A;
}

// A change of gains is bumpless at what the last step saw, so that a reference that steps with the phase steps the
// valve through the gains of the new phase.
double JointNode::valve_current_by_gains(double reference, const control::Measurement& measured,
                                         double probe_A) noexcept {
  const Slot& slot = acting_[static_cast<std::size_t>(phase_)];
  const bool changed = slot.issue != controller_issue_ || phase_ != controller_phase_;
  if (changed && controller_.set_gains(slot.gains, last_measured_, last_reference_)) {
    controller_issue_ = slot.issue;
    controller_phase_ = phase_;
  }
  if (controller_issue_ == 0) {
    return 0.0;  // gains that cannot be used; those are refused on arrival
  }
  last_measured_ = predictor_.predict(slot.gains.model, measured);
  last_reference_ = predictor_.predict(reference);
  const control::ForceController::Output output = controller_.step(last_reference_, last_measured_, probe_A);
  predictor_.sent(output.valve_current_A);
  // The controller limits to the scale its gains came with; the valve has the last word.
  const double limit_A = joint_.actuator.valve_current_max_A;
  const double current_A = std::clamp(output.valve_current_A, -limit_A, limit_A);
  faults_.set(Fault::kValveSaturated, output.saturated || current_A != output.valve_current_A);
  return current_A;
}

double JointNode::valve_current_by_physics(const control::ForceReference& reference,
                                           const control::Measurement& measured, double probe_A) noexcept {
  const Slot& slot = acting_[static_cast<std::size_t>(phase_)];
  const bool changed = slot.issue != controller_issue_ || phase_ != controller_phase_;
  if (changed && flow_inversion_->set_physics(slot.physics)) {
    controller_issue_ = slot.issue;
    controller_phase_ = phase_;
  }
  if (controller_issue_ == 0) {
    return 0.0;  // physics that cannot be used; those are refused on arrival
  }
  const control::FlowInversion::Output output = flow_inversion_->step(reference, measured, probe_A);
  faults_.set(Fault::kValveSaturated, output.saturated);
  return output.valve_current_A;
}

// Normalisation takes the speed of the open valve for 1: what it is exactly depends on load and side, by a factor that
// the low rate leaves room for.
double JointNode::holding_current(double position) noexcept {
  const double speed = -safety_.position_damping_1_s * (position - held_position_);
  const double wanted_A = joint_.normalisation.current_A * speed / joint_.normalisation.velocity;
  const double limit_A = joint_.actuator.valve_current_max_A;
  const double current_A = std::clamp(wanted_A, -limit_A, limit_A);
  faults_.set(Fault::kValveSaturated, current_A != wanted_A);
  return current_A;
}

void JointNode::reset_controller() noexcept {
  compensation_.reset();
  equaliser_.reset();
  predictor_.reset();
  controller_.reset();
  pid_.reset();
  if (flow_law_) {
    flow_law_->reset();
  }
  if (flow_inversion_) {
    flow_inversion_->reset();
  }
  controller_issue_ = 0;
  last_measured_ = {};
  last_reference_ = 0.0;
  faults_.set(Fault::kReferenceClamped, false);
  faults_.set(Fault::kValveSaturated, false);
}

}  // namespace farrier::joint_node
