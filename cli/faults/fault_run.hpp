#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "gait/schedule.hpp"
#include "participant/options.hpp"
#include "robot/robot.hpp"
#include "cli/processes/pause_watch.hpp"
#include "tools/faults/fault_cell.hpp"

namespace farrier::cli {

/// A cell of the table of faults that is to be run.
struct CellPlan {
  const faults::Row* row;
  gait::Phase phase;
  std::string vendor;  ///< of fault_vendors()
  std::uint64_t seed;

  faults::Cell cell() const;  ///< without what was seen
};

/// Cells of `rows`, the first seed's of all of them before the second's.
std::vector<CellPlan> plan_cells(const std::vector<const faults::Row*>& rows, const std::vector<std::string>& vendors,
                                 int seeds);

/// Names of what a run's processes may speak, for --dds.
const std::vector<std::string>& fault_vendors();

struct CellSettings {
  std::string robot_path;
  std::string out;  ///< directory of logs and of the trace
  int slow;
  participant::World world = participant::World::kBench;
};

/// One cell, judged by a run in which the computer did not stand still, or by the last of several in which it did.
/// Refuses when the user interrupts.
Result<faults::Cell> run_cell(const robot::Robot& robot, const CellSettings& settings, const CellPlan& plan,
                              const std::string& title, PauseWatch& pauses);

}  // namespace farrier::cli
