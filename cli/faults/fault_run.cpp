#include "cli/faults/fault_run.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/ensure.hpp"
#include "core/text.hpp"
#include "locomotion/motion_script.hpp"
#include "participant/loop.hpp"
#include "robot/keys.hpp"
#include "robot/locomotion_params.hpp"
#include "trace/body_trace.hpp"
#include "trace/trace.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/trot/trot_options.hpp"
#include "cli/trot/trot_run.hpp"
#include "tools/faults/tick_times.hpp"

namespace farrier::cli {
namespace {

/// Time from the end of a fault to the request to arm, and from the last act to the end of the run.
constexpr double kUntilArmed_s = 0.1;
constexpr double kAfterwards_s = 0.25;
/// The same of a body, which may sink or fall meanwhile.
constexpr double kAfterwardsOnGround_s = 2.0;

constexpr std::array kVendors{DdsChoice::kCyclone, DdsChoice::kFast, DdsChoice::kMixed};

DdsChoice choice_of(const std::string& vendor) {
  const auto found = std::ranges::find_if(kVendors, [&](DdsChoice choice) { return vendor == to_string(choice); });
  FARRIER_ENSURE(found != kVendors.end(), "the vendor of a cell is one of fault_vendors()");
  return *found;
}

/// The member that a row means: its own name, or the one that hosts the joint.
std::string member_of(const robot::Robot& robot, const std::vector<run::Member>& members, const std::string& name) {
  const std::string& joint = faults::hit_joint(robot).name;
  for (const run::Member& member : members) {
    const bool hosts = std::ranges::find(member.joints, joint) != member.joints.end();
    if (member.name == name || (name == "joint_node" && member.executable == name && hosts)) {
      return member.name;
    }
  }
  return name;
}

int slow_of(const CellSettings& settings, const faults::Row& row) {
  return settings.slow * (faults::starts_process(row) ? faults::kSlowerWhereProcessesStart : 1);
}

/// Longest pause of the computer in a cell.
Nanoseconds may_pause(const robot::Robot& robot, int slow) {
  return Nanoseconds(std::llround(1e9 * robot.period_s * slow));
}

/// Span of the row's fault in a run of that world. A body is hit in its third stride or later.
faults::TickSpan span_of(const robot::Robot& robot, const CellSettings& settings, const faults::Row& row,
                         const faults::CellPlan& plan) {
  if (!participant::is_on_ground(settings.world)) {
    return faults::place_of(robot, gait::Schedule(robot.plan, plan.seed), row, plan.phase);
  }
  constexpr Tick kStrides = 3;
  const gait::Schedule schedule(robot::locomotion_plan(robot.plan), plan.seed);
  const Tick walks = std::llround(locomotion::kWalk_s / robot.period_s) - schedule.lead_in_ticks();
  faults::TickSpan span =
      faults::place_of(robot, schedule, row, plan.phase, schedule.lead_in_ticks() + kStrides * schedule.stride_ticks());
  span.begin += walks;
  span.end += walks;
  return span;
}

/// One run of a cell, judged. Refuses when the user interrupts.
Result<faults::Cell> run_cell_once(const robot::Robot& robot, const CellSettings& settings,
                                   const faults::CellPlan& plan, const std::string& title, PauseWatch& pauses) {
  const int slow = slow_of(settings, *plan.row);
  const faults::Row row = faults::paced(*plan.row, slow);
  const auto ticks = [&](double time_s) { return static_cast<Tick>(std::llround(time_s / robot.period_s)); };
  const faults::TickSpan span = span_of(robot, settings, row, plan);
  faults::Cell cell = plan.cell();
  TrotOptions trot;
  trot.robot_path = settings.robot_path;
  trot.dds = choice_of(plan.vendor);
  trot.clock = bus::ClockKind::kRealtime;
  trot.nodes = run::Grouping::kPerLeg;  // rows name the process of a leg
  trot.design = row.design;
  trot.standby = row.standby;
  trot.world = settings.world;
  trot.seed = plan.seed;
  trot.out = settings.out;
  trot.trace_path = settings.out + "/trace.csv";
  DdsRun run = dds_run(robot, trot, title);
  run.common.slow = slow;
  run.goes_on_without_the_dead = true;
  faults::TickTimes times;
  run.looks_on = [&](Tick tick) {
    times.saw(tick, std::chrono::steady_clock::now());  // the computer's, as pauses are
    if (tick < span.begin - faults::kBefore - faults::kAfterPause) {
      pauses.forget();
    }
  };
  const auto members = run::plan_members(robot, run.grouping, run.standby);
  if (row.member != nullptr) {
    run.faults[member_of(robot, members, row.member)] = faults::arrow_faults(robot, row, span);
  }
  for (const run::ProcessAct& act : row.acts) {
    run.acts.push_back(
        {.at = span.begin + ticks(act.at_s), .member = member_of(robot, members, act.member), .signal = act.signal});
  }
  if (row.expected.latches) {
    run.acts.push_back({.at = span.end + ticks(kUntilArmed_s), .member = {}});
  }
  const Tick last = run.acts.empty() ? span.end : std::max(span.end, run.acts.back().at);
  const bool on_ground = participant::is_on_ground(settings.world);
  run.common.ticks = last + ticks(on_ground ? kAfterwardsOnGround_s : kAfterwards_s);
  const auto ran = run_over_dds(robot, run);
  if (participant::stop_requested()) {
    return Error{"interrupted"};
  }
  const auto trace = faults::leaves_trace(row) ? trace::read_trace(run.common.trace_path, robot::joint_names(robot))
                                               : Result<std::vector<trace::TraceRow>>(std::vector<trace::TraceRow>{});
  if (!ran || !trace) {
    cell.error = !ran ? ran.error().message : join(ran.value().warnings, "; ");
    cell.error += !ran ? "" : (cell.error.empty() ? "" : "; ") + trace.error().message;
    return cell;
  }
  const std::vector<Tick>& acted = ran.value().acted;
  if (acted.size() < run.acts.size()) {
    cell.error = "the run ended before all was done to it";
    return cell;
  }
  faults::Moments moments{span, last, {}};
  for (const Pause& pause : pauses.longer_than(may_pause(robot, slow))) {
    moments.pauses.push_back(times.between(pause.begin, pause.end));
  }
  if (!row.acts.empty()) {
    moments.fault.begin = acted.front();
    moments.fault.end = row.acts.size() > 1 ? acted[row.acts.size() - 1] : acted.front() + ticks(row.lasts_s);
  }
  if (row.expected.latches) {
    moments.armed = acted.back();
  }
  std::vector<faults::Heard> heard;
  for (std::size_t i = 0; i < ran.value().events.size(); ++i) {
    heard.push_back({std::string(signals::text_of(ran.value().events[i].text)), ran.value().events_heard[i]});
  }
  cell.checks = faults::judge(robot, row, moments, trace.value(), heard);
  if (on_ground && faults::leaves_trace(row)) {
    const auto truth =
        trace::read_body_trace(trace::body_trace_path(run.common.trace_path), static_cast<int>(robot.plan.legs.size()));
    if (!truth) {
      cell.error = truth.error().message;
      return cell;
    }
    const gait::Schedule schedule(robot::locomotion_plan(robot.plan), plan.seed);
    cell.body = faults::body_after_fault(truth.value(), moments.fault.begin,
                                         {trot.velocity[0], schedule.stride_ticks(), robot.period_s});
    if (faults::walks_on(row)) {
      cell.checks.push_back(faults::walks_on_check(*cell.body));
    }
  }
  return cell;
}

}  // namespace

const std::vector<std::string>& fault_vendors() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const DdsChoice vendor : kVendors) {
      all.emplace_back(to_string(vendor));
    }
    return all;
  }();
  return names;
}

Result<faults::Cell> run_cell(const robot::Robot& robot, const CellSettings& settings, const faults::CellPlan& plan,
                              const std::string& title, PauseWatch& pauses) {
  for (int repeats = 0;; ++repeats) {
    auto cell = run_cell_once(robot, settings, plan, title, pauses);
    if (!cell) {
      return cell.error();
    }
    const bool paused = pauses.longest() > may_pause(robot, slow_of(settings, *plan.row));
    if (!paused || cell.value().holds() || repeats == settings.most_repeats) {
      cell.value().repeats = repeats;
      return cell;
    }
  }
}

}  // namespace farrier::cli
