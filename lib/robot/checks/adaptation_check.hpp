#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Adds the estimator of joints that name none, when no section has its name.
void add_default_estimator(RobotFile& file);

/// What the estimators and the update logic ask that does not fit the periods and the gait of the file.
config::Problems check_adaptation(const RobotFile& file);

}  // namespace farrier::robot
