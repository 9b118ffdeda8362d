#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Returns the problems of the deployment section. Every joint must be hosted once. The processes sim_bridge,
/// estimator_service and supervisor must run once, locomotion at most once. Processes and addresses must differ, and
/// addresses of several hosts must be reachable from each other. References must be good.
config::Problems check_deployment(const RobotFile& file);

}  // namespace farrier::robot
