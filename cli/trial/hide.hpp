#pragma once

#include "robot/robot.hpp"
#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// farrier trot --hide: an effect that only sim_bridge knows is looked for in the recording of a run. The options name
/// their trace, their figures and their recording. The command's exit status.
int hide(const robot::Robot& robot, const TrotOptions& options);

}  // namespace farrier::cli
