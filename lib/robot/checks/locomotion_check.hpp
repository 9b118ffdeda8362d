#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Checks the section locomotion against body, legs and joints; no problem without the section.
config::Problems check_locomotion(const RobotFile& file);

}  // namespace farrier::robot
