#include "report/trot/joint_poles.hpp"

#include "robot/joint_model.hpp"
#include "supervisor/joint_design.hpp"

namespace farrier::report {

Result<JointPoles> joint_poles(const robot::Joint& joint, double period_s, int loop_delay_ticks) {
  const auto stance = FARRIER_TRY(supervisor::design_joint(joint, joint.stance_load, period_s, loop_delay_ticks));
  const auto swing = FARRIER_TRY(supervisor::design_joint(joint, joint.swing_load, period_s, loop_delay_ticks));
  const control::DiscreteModel stance_model = robot::model_of(joint, joint.stance_load, period_s);
  const control::DiscreteModel swing_model = robot::model_of(joint, joint.swing_load, period_s);
  const auto poles = [&](const control::DiscreteModel& model, const control::Gains& gains) {
    return control::closed_loop_poles(model, gains, loop_delay_ticks);
  };
  const auto radius = [&](const control::DiscreteModel& model, const control::Gains& gains) {
    return control::closed_loop_spectral_radius(model, gains, loop_delay_ticks);
  };
  return JointPoles{.stance_on_stance = poles(stance_model, stance),
                    .stance_on_swing = poles(swing_model, stance),
                    .swing_on_stance = poles(stance_model, swing),
                    .stance_spectral_radius = radius(stance_model, stance),
                    .swing_spectral_radius = radius(swing_model, swing),
                    .stance_on_swing_spectral_radius = radius(swing_model, stance),
                    .swing_on_stance_spectral_radius = radius(stance_model, swing)};
}

Result<Done> add_spectral_radii(Figures& figures, const robot::Robot& robot, int loop_delay_ticks) {
  for (const robot::Joint& joint : robot.joints) {
    const auto poles = FARRIER_TRY(joint_poles(joint, robot.period_s, loop_delay_ticks));
    figures.add("trot." + joint.name + ".stance_spectral_radius", poles.stance_spectral_radius, 1.0);
    figures.add("trot." + joint.name + ".swing_spectral_radius", poles.swing_spectral_radius, 1.0);
  }
  return Done{};
}

}  // namespace farrier::report
