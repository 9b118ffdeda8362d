#include "supervisor/joint_design.hpp"

#include "robot/joint_model.hpp"

namespace farrier::supervisor {

Result<control::Gains> design_joint(const robot::Joint& joint, const plant::LoadParams& load, double period_s,
                                    int delay_ticks) {
  const auto gains = control::design(robot::model_of(joint, load, period_s), joint.design, joint.normalisation,
                                     joint.form, delay_ticks, period_s);
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
