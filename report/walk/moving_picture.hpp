#pragma once

#include <string>

#include "report/walk/walk_run.hpp"

namespace farrier::report {

/// A moving SVG of the last seconds of a walk: the robot on the ground's plane, and the forces of the ground on its feet.
/// With a pump it has, beside the robot, pressure and flows of the supply, and chamber pressures and valve current of the
/// last joint of the first leg. It plays in a browser without a script, at the speed of the run, for ever. Boxes of a
/// scene are not drawn. Empty for a run shorter than a loop, and for a robot whose file describes no rigid bodies.
std::string moving_picture(const WalkRun& run);

}  // namespace farrier::report
