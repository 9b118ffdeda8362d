#pragma once

// When the joints of a walk changed gains, against the plan and the true contacts of the feet.

#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "report/page/picture.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "trace/trace.hpp"

namespace farrier::report {

/// The gains of a walk. Refers to what it is made of.
struct GaitChanges {
  std::span<const signals::GaitPhase> phases;  ///< that joints were told, in the order of each leg's counts
  std::span<const trace::TraceRow> rows;       ///< in the order of their ticks
};

/// Adds trot.body.planned_switches, felt_switches, late_touchdowns, mean_late_ms and largest_late_ms.
void add_gait_changes(Figures& figures, const robot::Robot& robot, const GaitChanges& changes);

/// A panel per leg from tick `begin` to `end`: the planned phase, the contact of the foot, and the phase whose gains act.
/// Each is high in stance. Touchdowns that were felt are points on the third line.
std::vector<Panel> gait_panels(const robot::Robot& robot, const GaitChanges& changes, Tick begin, Tick end);

}  // namespace farrier::report
