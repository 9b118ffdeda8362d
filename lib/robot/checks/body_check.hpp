#pragma once

#include "config/problem.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Problems of a robot that its file describes as rigid bodies: with body.trunk, each leg must have a hip position and
/// three joints, and each body an inertia that is positive definite. Without it, the file must give none of the rest.
config::Problems check_body(const RobotFile& file);

}  // namespace farrier::robot
