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

}  // namespace farrier::robot
