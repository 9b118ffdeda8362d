#include "robot/joint_plant.hpp"

#include <utility>

namespace farrier::robot {

Result<plant::Joint> make_plant(const Joint& joint, const plant::LoadParams& load) {
  const double home = joint.linkage.position(joint.home_angle_rad);
  if (joint.electric) {
    auto made = plant::ElectricJoint::create(*joint.electric, load,
                                             plant::equilibrium(*joint.electric, load, home, 0.0));
    return made ? Result<plant::Joint>(plant::Joint(std::move(made).value())) : Result<plant::Joint>(made.error());
  }
  auto made = plant::HydraulicJoint::create(joint.actuator, load, plant::equilibrium(joint.actuator, load, home, 0.0),
                                            plant::HydraulicJoint::kDefaultTolerance, joint.effects);
  return made ? Result<plant::Joint>(plant::Joint(std::move(made).value())) : Result<plant::Joint>(made.error());
}

}  // namespace farrier::robot
