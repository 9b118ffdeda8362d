#include "supervisor/joint_design.hpp"

#include "control/design/filtered_loop.hpp"
#include "robot/joint_model.hpp"
#include "robot/sensor_path.hpp"
#include "supervisor/law_check.hpp"

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
  const std::string filters = robot::filters_text(joint);
  if (joint.kind == control::Kind::kLqr &&
      !control::filtered_loop_is_stable(gains.value().model, gains.value(), delay_ticks,
                                        robot::measurement_filters(joint, period_s))) {
    return Error{joint.name + ": the controller for a load of " + std::to_string(load.mass) +
                 (filters.empty() ? " is unstable" : " is unstable behind the sensors' " + filters) +
                 (filters.empty()           ? ": lower integral_factor"
                  : joint.equalises_filters ? ": raise the cut-offs, or lower integral_factor"
                                            : ": set equalise_filters: true in the controller, or raise the cut-offs")};
  }
  if (filters.empty() || joint.electric) {
    return gains.value();
  }
  const plant::JointPhysics physics = robot::nominal_physics(joint, load);
  if (!LawCheck(joint, period_s, delay_ticks).settles(physics, physics)) {
    return Error{joint.name + ": its controller does not settle on a load of " + std::to_string(load.mass) +
                 " behind the sensors' " + filters + ": raise the cut-offs, or give other gains"};
  }
  return gains.value();
}

}  // namespace farrier::supervisor
