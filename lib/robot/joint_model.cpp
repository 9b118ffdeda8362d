#include "robot/joint_model.hpp"

namespace farrier::robot {

control::DiscreteModel model_of(const Joint& joint, const plant::LoadParams& load, double period_s,
                                const ModelForm& form) {
  if (joint.electric) {
    const plant::LinearModel model = plant::linearise_load_cell_force(*joint.electric, load);
    return control::discretise(model.a, model.b, period_s);
  }
  plant::OperatingPoint home;
  home.position = joint.linkage.position(joint.home_angle_rad);
  home.valve_sign = form.valve_sign;
  const plant::LinearModel model =
      plant::linearise_load_cell_force(joint.actuator, load, home, plant::Volumes::kMoving, form.piston);
  return control::discretise(model.a, model.b, period_s);
}

plant::JointPhysics nominal_physics(const Joint& joint, const plant::LoadParams& load) noexcept {
  plant::JointPhysics physics = plant::nominal_physics(joint.actuator, load);
  for (const auto& [effect, coefficient] :
       {std::pair("internal_leakage", "coefficient_m3_s_Pa"), std::pair("valve_deadband", "leakage_m3_s_Pa")}) {
    if (const plant::ActiveEffect* known = plant::find(joint.effects, plant::find_effect(effect))) {
      physics.leakage += plant::parameter_value(*known, coefficient).value_or(0.0);
    }
  }
  if (const plant::ActiveEffect* valve = plant::find(joint.effects, plant::effect_id<plant::ValveDeadband>())) {
    physics.overlap_A = valve->values[0];
  }
  return physics;
}

}  // namespace farrier::robot
