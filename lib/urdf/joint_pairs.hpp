#pragma once

#include <vector>

#include "robot/robot.hpp"
#include "urdf/moving_bodies.hpp"

namespace farrier::urdf {

/// The body of a URDF behind each joint of the robot, in the robot's order; null where there is none. By name first
/// (upper or lower case, with or without "_joint" at the end). A leg of which no joint is found by name takes the chain
/// of joints on the root's body whose hip is nearest to its own. The robot must have a body.
std::vector<const MovingBody*> paired_bodies(const std::vector<MovingBody>& bodies, const robot::Robot& robot);

}  // namespace farrier::urdf
