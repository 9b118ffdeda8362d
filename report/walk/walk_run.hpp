#pragma once

#include <algorithm>
#include <span>

#include "core/units.hpp"
#include "report/walk/gait_changes.hpp"
#include "report/walk/walk.hpp"
#include "robot/robot.hpp"
#include "trace/supply_trace.hpp"
#include "trace/trace.hpp"

namespace farrier::report {

/// Length of the moving picture.
inline constexpr double kMovingPicture_s = 5.0;

/// The truth of a simulated walk; each in the order of its ticks.
struct WalkRun {
  const robot::Robot& robot;
  const WalkPlan& plan;
  const WalkFigures& figures;
  std::span<const signals::BodyTruth> truth;  ///< a row a tick
  std::span<const trace::SupplyRow> supply;   ///< empty without a pump
  GaitChanges changes = {};                   ///< a row a tick and joint; empty where nobody wrote them down

  double time_s(Tick tick) const noexcept { return static_cast<double>(tick) * plan.period_s; }
  /// Time from which pictures show `seconds` in full: they end with the fall or with the run.
  double shown_from_s(double seconds) const noexcept {
    const double last_s = truth.empty() ? 0.0 : time_s(truth.back().tick);
    return std::max(0.0, figures.fell_s.value_or(last_s) - seconds);
  }
  /// The rows of all joints from the tick on in which that time lies.
  std::span<const trace::TraceRow> shown_joints(double seconds) const noexcept {
    const auto from = static_cast<Tick>(shown_from_s(seconds) / plan.period_s);
    return {std::ranges::lower_bound(changes.rows, from, {}, &trace::TraceRow::tick), changes.rows.end()};
  }
};

/// Writes out_dir/index.html with pictures of height, tilt, speed and forces at the feet beside it; after a fall also of
/// its last second. A robot with a pump adds the supply, the account of its energy, and the valve currents and pressures
/// of each leg. Changes of gains have a picture of the settled trot, or of the last second before a fall. A moving picture
/// shows the last seconds. Refuses for the reasons of Drawing::draw.
Result<std::string> write_walk_report(const std::string& out_dir, const Outcome& outcome, const WalkRun& run);

}  // namespace farrier::report
