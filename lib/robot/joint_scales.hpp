#pragma once

#include "plant/terms/term.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Sizes that make the parameters of a joint's effects comparable; torques of an electric joint by its rated one.
inline plant::Scales scales_of(const Joint& joint) {
  return joint.electric ? plant::Scales(*joint.electric, joint.swing_load, joint.push_limit)
                        : plant::Scales(joint.actuator, joint.swing_load);
}

}  // namespace farrier::robot
