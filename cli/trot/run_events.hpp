#pragma once

#include <span>
#include <string>

#include "robot/robot.hpp"
#include "cli/processes/dds_run.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::cli {

/// Writes what changed in the run, a line an event and a line a decision about gains, in the order of their ticks.
void write_events(const std::string& path, const robot::Robot& robot, const RunOutcome& run,
                  std::span<const report::DecisionInfo> decisions);

}  // namespace farrier::cli
