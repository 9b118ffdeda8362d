#include "tools/report/joint_poles.hpp"

#include "supervisor/joint_design.hpp"

namespace farrier::report {

Result<JointPoles> joint_poles(const robot::Joint& joint, double period_s, int loop_delay_ticks) {
  const auto stance = supervisor::design_joint(joint, joint.stance_load, period_s, loop_delay_ticks);
  const auto swing = supervisor::design_joint(joint, joint.swing_load, period_s, loop_delay_ticks);
  if (!stance || !swing) {
    return stance ? swing.error() : stance.error();
  }
  const control::DiscreteModel stance_model = supervisor::model_of(joint, joint.stance_load, period_s);
  const control::DiscreteModel swing_model = supervisor::model_of(joint, joint.swing_load, period_s);
  return JointPoles{
      .stance_on_stance = control::closed_loop_poles(stance_model, stance.value(), loop_delay_ticks),
      .stance_on_swing = control::closed_loop_poles(swing_model, stance.value(), loop_delay_ticks),
      .swing_on_stance = control::closed_loop_poles(stance_model, swing.value(), loop_delay_ticks),
      .stance_spectral_radius = control::closed_loop_spectral_radius(stance_model, stance.value(), loop_delay_ticks),
      .swing_spectral_radius = control::closed_loop_spectral_radius(swing_model, swing.value(), loop_delay_ticks)};
}

Result<Done> add_spectral_radii(Figures& figures, const robot::Robot& robot, int loop_delay_ticks) {
  for (const robot::Joint& joint : robot.joints) {
    const auto poles = joint_poles(joint, robot.period_s, loop_delay_ticks);
    if (!poles) {
      return poles.error();
    }
    figures.add("trot." + joint.name + ".stance_spectral_radius", poles.value().stance_spectral_radius, 1.0);
    figures.add("trot." + joint.name + ".swing_spectral_radius", poles.value().swing_spectral_radius, 1.0);
  }
  return Done{};
}

}  // namespace farrier::report
