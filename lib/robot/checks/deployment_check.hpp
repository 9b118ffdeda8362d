#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// What the deployment section asks of the robot and of itself: every joint is hosted once; sim_bridge,
/// estimator_service and supervisor run once, gait_source at most once; processes and addresses differ, and addresses
/// of several hosts can be reached from each other. References must be good.
config::Problems check_deployment(const RobotFile& file);

}  // namespace farrier::robot
