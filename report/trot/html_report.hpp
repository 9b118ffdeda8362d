#pragma once

#include <span>
#include <string>

#include "core/result.hpp"
#include "gait/schedule.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// A finished run. Refers to what it is made of; lives no longer than a call.
struct ReportInput {
  const Outcome& outcome;
  const robot::Robot& robot;
  const gait::Schedule& schedule;
  std::span<const trace::TraceRow> rows;
  int loop_delay_ticks;  ///< of the run's clock
  std::span<const signals::JointControllerGains> gains = {};  ///< every update issued
};

/// Writes out_dir/index.html with its pictures beside it, making the folder where needed, and returns the page's
/// path. The page needs nothing from elsewhere. Refuses for the reasons draw_pictures does.
Result<std::string> write_report(const std::string& out_dir, const ReportInput& input);

}  // namespace farrier::report
