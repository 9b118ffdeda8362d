#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// Puts effects of an electric joint into the values of its drive and its load; a drive or a load that other joints
/// have too is copied first. Returns the reasons why effects are left out, a sentence each: a robot file has no value
/// for them.
std::vector<std::string> put_into_drive_and_load(robot::RobotFile& file, const robot::Joint& joint,
                                                 std::span<const plant::ActiveEffect> effects);

}  // namespace farrier::report
