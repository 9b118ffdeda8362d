#pragma once

#include "robot/robot_file.hpp"

namespace farrier::robot {

/// The electric actuator of that joint, null if it is hydraulic or there is none of its name.
const ElectricActuator* electric_actuator_of(const RobotFile& file, const JointTemplate& joint);

/// Travel of that joint's actuator, m or rad. It must be in the file.
double stroke_of(const RobotFile& file, const JointTemplate& joint);

/// Returns the problems of electric joints that use hydraulic features. These are effects, a controller that inverts
/// the flow of oil, and an estimator of its physics. Their load must be a rotary one and their linkage a direct one.
/// Also reports two actuators of one name, and hydraulic actuators without a supply. Names that refer to nothing are
/// checked elsewhere.
config::Problems check_electric(const RobotFile& file);

}  // namespace farrier::robot
