#pragma once

#include "plant/joint.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// The joint as it is simulated, with its effects: at rest at its home pose under `load`. Refuses what cannot be
/// simulated, without naming the joint.
Result<plant::Joint> make_plant(const Joint& joint, const plant::LoadParams& load);

}  // namespace farrier::robot
