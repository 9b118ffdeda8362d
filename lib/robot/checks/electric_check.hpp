#pragma once

#include "robot/robot_file.hpp"

namespace farrier::robot {

/// The electric actuator of that joint, null where it is hydraulic or there is none of its name.
const ElectricActuator* electric_actuator_of(const RobotFile& file, const JointTemplate& joint);

/// Travel of that joint's actuator, m or rad. It must be in the file.
double stroke_of(const RobotFile& file, const JointTemplate& joint);

/// What only a hydraulic joint has, asked of an electric one: effects, a load that is no rotary one, a linkage that is
/// no direct one, a controller that inverts the flow of oil, an estimator of its physics. Actuators of one name.
/// Hydraulic actuators without a supply. Names that refer to nothing are no matter of this.
config::Problems check_electric(const RobotFile& file);

}  // namespace farrier::robot
