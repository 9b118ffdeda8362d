#pragma once

#include "robot/robot_file.hpp"

namespace farrier::robot {

/// Returns the problems between sections other than references and adaptation: the stance lead must fit into the
/// announcement, and these legs must be able to carry the body of varied robots. References must be good.
config::Problems check_between_sections(const RobotFile& file);

}  // namespace farrier::robot
