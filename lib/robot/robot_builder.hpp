#pragma once

#include "config/problem.hpp"
#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Derives the robot from its file, or says what does not fit together.
Result<Robot, config::Problems> build_robot(RobotFile file);

}  // namespace farrier::robot
