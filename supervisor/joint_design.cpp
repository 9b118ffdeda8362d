#include "supervisor/joint_design.hpp"

#include "plant/linear_model.hpp"

namespace farrier::supervisor {

control::DiscreteModel model_of(const robot::Joint& joint, const plant::LoadParams& load, double period_s) {
  plant::OperatingPoint home;
  home.position = joint.linkage.position(joint.home_angle_rad);
  home.valve_sign = 1.0;
  const plant::LinearModel model = plant::linearise_load_cell_force(joint.actuator, load, home);
  return control::discretise(model.a, model.b, period_s);
}

Result<control::Gains> design_joint(const robot::Joint& joint, const plant::LoadParams& load, double period_s,
                                    int delay_ticks) {
  const auto gains = control::design_lqr(model_of(joint, load, period_s), joint.weights, joint.normalisation,
                                         joint.form, delay_ticks);
  if (!gains) {
    return Error{joint.name + ": no controller for a load of " + std::to_string(load.mass) +
                 (joint.form == control::Form::kFullState && gains.error() == control::DesignStatus::kNotStabilisable
                      ? " in the full-state form without a load spring, set form: compliant ("
                      : " (") +
                 control::to_string(gains.error()) + ")"};
  }
  return gains.value();
}

}  // namespace farrier::supervisor
