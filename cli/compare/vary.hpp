#pragma once

#include <string>

#include "robot/robot.hpp"
#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// farrier trot --vary: the gait of `o.seeds` varied robots under every contender, in process. Writes every result to
/// `rows_path`, the figures to `o.json_path`, both known to be writable, and a summary to standard output. Returns the
/// exit status.
int vary(const robot::Robot& robot, const TrotOptions& o, const std::string& rows_path);

}  // namespace farrier::cli
