#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Every name in the file that refers to nothing, or to something of the wrong kind; joints named twice; legs that
/// are neither legs nor rigs. Empty when the file can be built.
config::Problems check_references(const RobotFile& file);

}  // namespace farrier::robot
