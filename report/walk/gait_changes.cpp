#include "report/walk/gait_changes.hpp"

#include <algorithm>

#include "gait/late_touchdowns.hpp"

namespace farrier::report {
namespace {

constexpr double kPerSecond_ms = 1e3;
constexpr double kRise = 0.7;  // of a line in stance, above its row

/// True for the rows of one joint of each leg, which stand for the leg.
bool of_first_joint(const robot::Robot& robot, const trace::TraceRow& row) {
  return robot.joints.at(row.joint).index_in_leg == 0;
}

double height(std::size_t line, Phase phase) {
  return static_cast<double>(line) + (phase == Phase::kStance ? kRise : 0.0);
}

Panel panel_of(const robot::Robot& robot, const GaitChanges& changes, int leg, Tick begin, Tick end) {
  constexpr std::size_t kGains = 0, kContact = 1, kPlan = 2;
  Series plan{.style = Style::kSteps, .colour = 5}, contact{.style = Style::kSteps, .colour = 1};
  Series gains{.style = Style::kSteps}, felt{.label = "touchdown felt", .style = Style::kDiscs, .colour = 2};
  const auto seconds = [&robot](Tick tick) { return static_cast<double>(tick) * robot.period_s; };
  Phase planned = Phase::kStance;
  auto next = changes.phases.begin();
  for (const trace::TraceRow& row : changes.rows) {
    if (robot.joints.at(row.joint).leg != leg || !of_first_joint(robot, row)) {
      continue;
    }
    for (; next != changes.phases.end() && (next->leg != leg || next->felt != 0 || next->switch_tick <= row.tick);
         ++next) {
      if (next->leg == leg && next->felt == 0) {
        planned = next->phase;
      } else if (next->leg == leg && next->switch_tick >= begin && next->switch_tick < end) {
        felt.add(seconds(next->switch_tick), height(kGains, Phase::kStance));
      }
    }
    if (row.tick >= begin && row.tick < end) {
      plan.add(seconds(row.tick), height(kPlan, planned));
      contact.add(seconds(row.tick), height(kContact, row.actual_phase));
      gains.add(seconds(row.tick), height(kGains, row.phase));
    }
  }
  return {.y_label = robot.plan.legs[static_cast<std::size_t>(leg)].name,
          .series = {plan, contact, gains, felt},
          .x_range = Range{seconds(begin), seconds(end)},
          .rows = {"gains", "contact", "plan"}};
}

}  // namespace

void add_gait_changes(Figures& figures, const robot::Robot& robot, const GaitChanges& changes) {
  std::vector<gait::LateTouchdowns> legs(robot.plan.legs.size());
  for (const trace::TraceRow& row : changes.rows) {
    if (of_first_joint(robot, row)) {
      legs[static_cast<std::size_t>(robot.joints[row.joint].leg)].step(row.actual_phase, row.phase);
    }
  }
  const gait::LateTotal late = gait::total_of(legs);
  const auto felt = std::ranges::count_if(changes.phases, [](const auto& phase) { return phase.felt != 0; });
  const double tick_ms = kPerSecond_ms * robot.period_s;
  figures.add("trot.body.planned_switches", static_cast<double>(std::ssize(changes.phases) - felt));
  figures.add("trot.body.felt_switches", static_cast<double>(felt));
  figures.add("trot.body.late_touchdowns", late.count);
  figures.add("trot.body.mean_late_ms", late.count > 0 ? tick_ms * late.sum / late.count : 0.0);
  figures.add("trot.body.largest_late_ms", tick_ms * late.largest);
}

std::vector<Panel> gait_panels(const robot::Robot& robot, const GaitChanges& changes, Tick begin, Tick end) {
  std::vector<Panel> panels;
  for (std::size_t leg = 0; leg < robot.plan.legs.size(); ++leg) {
    panels.push_back(panel_of(robot, changes, static_cast<int>(leg), begin, end));
  }
  if (!panels.empty()) {
    panels.back().x_label = "time, s";
  }
  return panels;
}

}  // namespace farrier::report
