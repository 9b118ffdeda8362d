#pragma once

#include "robot/robot_file.hpp"

namespace farrier::robot {

/// What sections ask of each other besides references and adaptation: the stance lead fits into the announcement, the
/// body of varied robots is one that these legs can carry. References must be good.
config::Problems check_between_sections(const RobotFile& file);

}  // namespace farrier::robot
