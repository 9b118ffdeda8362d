#pragma once

#include <string>

#include "report/walk/walk_run.hpp"

namespace farrier::report {

/// A moving SVG of the last seconds of a walk: the robot on the ground's plane, forces of the ground on its feet and, with
/// a pump, beside it the pressure and flows of the supply and the chamber pressures and valve current of one joint, the
/// last of the first leg. It plays in a browser without a script, at the speed of the run, for ever. Boxes of a scene are
/// not drawn. Empty for a run shorter than a loop, and for a robot whose file describes no rigid bodies.
std::string moving_picture(const WalkRun& run);

}  // namespace farrier::report
