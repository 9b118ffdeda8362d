#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "participant/options.hpp"
#include "robot/robot.hpp"
#include "cli/processes/pause_watch.hpp"
#include "tools/faults/cell_plan.hpp"

namespace farrier::cli {

/// Names of what a run's processes may speak, for --dds.
const std::vector<std::string>& fault_vendors();

struct CellSettings {
  std::string robot_path;
  std::string out;  ///< directory of logs and of the trace
  int slow;
  int most_repeats;  ///< of a cell that did not hold while the computer was paused; >= 0
  participant::World world = participant::World::kBench;
};

/// One cell, judged by a run in which the computer was not paused, or by the last of several in which it was.
/// Refuses when the user interrupts.
Result<faults::Cell> run_cell(const robot::Robot& robot, const CellSettings& settings, const faults::CellPlan& plan,
                              const std::string& title, PauseWatch& pauses);

}  // namespace farrier::cli
