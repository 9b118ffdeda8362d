#include "supervisor/law_check.hpp"

#include <type_traits>

#include "control/design/law_trial.hpp"
#include "control/law/feedback_linearisation.hpp"
#include "control/law/flow_inversion.hpp"
#include "control/law/force_controller.hpp"
#include "control/law/pid.hpp"
#include "robot/sensor_path.hpp"

namespace farrier::supervisor {
namespace {

constexpr double kStepShare = 0.01;     // of the force that counts as 1: well within the valve's range
constexpr double kSettledAtMost = 0.5;  // of the step: an oscillating loop is beyond the whole of it
constexpr int kInversionTicks = 40;     // it asks for nine tenths of the error within a tick
constexpr int kFilteredTicks = 200;     // behind filters an oscillation grows slowly
constexpr int kSlowLawTicks = 400;      // of laws with an integral

control::MeasurementFilters without_equalisers(robot::Joint joint, double period_s) {
  joint.equalises_filters = false;
  return robot::measurement_filters(joint, period_s);
}

}  // namespace

LawCheck::LawCheck(const robot::Joint& joint, double period_s, int delay_ticks)
    : joint_(joint),
      sensors_(without_equalisers(joint, period_s)),
      filters_(robot::measurement_filters(joint, period_s)),
      home_position_(joint.linkage.position(joint.home_angle_rad)),
      slack_position_(joint.stance_load.equilibrium_position),
      lever_(joint.linkage.lever(joint.home_angle_rad)),
      period_s_(period_s),
      delay_ticks_(delay_ticks) {}

template <class Law>
bool LawCheck::runs(Law law, int ticks, const plant::JointPhysics& actual) const noexcept {
  const control::LawTrial trial{.actuator = joint_.actuator,
                                .position = home_position_,
                                .slack_position = slack_position_,
                                .force_step = kStepShare * joint_.normalisation.force,
                                .outer_stiffness = joint_.stiffness_Nm_rad / (lever_ * lever_),
                                .outer_damping = joint_.damping_Nms_rad / (lever_ * lever_),
                                .period_s = period_s_,
                                .delay_ticks = delay_ticks_,
                                .sensors = sensors_,
                                .filters = filters_,
                                .ticks = ticks};
  return control::trial_error(trial, actual,
                              [&law](const control::ForceReference& reference, const control::Measurement& measured) {
                                if constexpr (std::is_same_v<Law, control::FlowInversion>) {
                                  return law.step(reference, measured).valve_current_A;
                                } else {
                                  return law.step(reference.force, measured).valve_current_A;
                                }
                              }) < kSettledAtMost;
}

bool LawCheck::settles(const plant::JointPhysics& told, const plant::JointPhysics& actual) const noexcept {
  if (joint_.electric) {
    return true;
  }
  switch (joint_.kind) {
    case control::Kind::kLqr:
      break;
    case control::Kind::kFeedbackLinearisation: {
      // A leakage damps. A law without an integral does not remove the force that it costs, and that is no instability.
      control::FeedbackLinearisation law(joint_.actuator, joint_.feedback_linearisation, home_position_, period_s_);
      plant::JointPhysics tight_told = told, tight = actual;
      tight_told.leakage = tight.leakage = 0.0;
      return law.set_physics(tight_told) && runs(law, kSlowLawTicks, tight);
    }
    case control::Kind::kPid:
      return runs(control::Pid(joint_.pid, joint_.normalisation, period_s_), kSlowLawTicks, actual);
    case control::Kind::kFlowInversion: {
      control::FlowInversion law(joint_.actuator, joint_.flow_inversion, home_position_, slack_position_, period_s_,
                                 delay_ticks_);
      return law.set_physics(told) && runs(law, filters_.are_wires() ? kInversionTicks : kFilteredTicks, actual);
    }
  }
  return true;
}

bool LawCheck::settles(const control::Gains& gains, const plant::JointPhysics& actual) const noexcept {
  control::ForceController law;
  return law.set_gains(gains, {0.0, 0.0, 0.0}, 0.0) && runs(law, kSlowLawTicks, actual);
}

}  // namespace farrier::supervisor
