#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "run/inproc_run.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// The update logics (a) to (d) of Hubacher (2014), Section 5.3.1, in that order.
inline constexpr std::array kUpdateMethods{robot::UpdateMethod::kLimits, robot::UpdateMethod::kSmallError,
                                           robot::UpdateMethod::kWhiteError, robot::UpdateMethod::kDistinctPoles};

/// A run whose gains adapt by one update logic, and what that logic had to do.
struct UpdateLogicRun {
  std::vector<trace::TraceRow> rows;
  run::InprocResult result;
  std::uint64_t looks = 0;     ///< estimates looked at
  std::uint64_t designs = 0;   ///< controllers designed for them, whatever became of these
  std::uint64_t accepted = 0;  ///< gains issued from them
  double look_us = 0.0;        ///< mean wall time of a look, designs included
};

/// Runs `robot` with adaptive gains by `method`, its update_logic otherwise as it is; `settings` says the rest. Looks,
/// designs and time are those of a second supervisor that is shown the same estimates in the same ticks, and so does
/// the same. Refuses what run::run_inproc refuses.
Result<UpdateLogicRun> run_update_logic(robot::Robot robot, robot::UpdateMethod method, run::InprocRun settings);

}  // namespace farrier::trials
