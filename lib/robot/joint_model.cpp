#include "robot/joint_model.hpp"

#include "plant/linear_model.hpp"

namespace farrier::robot {

control::DiscreteModel model_of(const Joint& joint, const plant::LoadParams& load, double period_s) {
  if (joint.electric) {
    const plant::LinearModel model = plant::linearise_load_cell_force(*joint.electric, load);
    return control::discretise(model.a, model.b, period_s);
  }
  plant::OperatingPoint home;
  home.position = joint.linkage.position(joint.home_angle_rad);
  home.valve_sign = 1.0;
  const plant::LinearModel model = plant::linearise_load_cell_force(joint.actuator, load, home);
  return control::discretise(model.a, model.b, period_s);
}

}  // namespace farrier::robot
