#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Adds the estimator of joints that name none, if no section has its name.
void add_default_estimator(RobotFile& file);

/// Returns the problems of estimators and update logic with the periods and the gait of the file.
config::Problems check_adaptation(const RobotFile& file);

}  // namespace farrier::robot
