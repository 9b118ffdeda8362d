#pragma once

#include "robot/robot.hpp"

namespace farrier::trials {

/// The robot with a grey-box estimator and flow inversion on every joint, and no dither: the estimator section
/// "greybox" of its file, or the method's defaults where there is none.
robot::Robot with_grey_box(robot::Robot robot);

}  // namespace farrier::trials
