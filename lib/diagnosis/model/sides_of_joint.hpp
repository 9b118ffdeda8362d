#pragma once

#include <memory>

#include "diagnosis/model/joint_sides.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// The sides of a joint of a robot file with its swing load, hydraulic or electric. Effects of the file are known.
std::unique_ptr<JointSides> sides_of(const robot::Joint& joint);

}  // namespace farrier::diagnosis
