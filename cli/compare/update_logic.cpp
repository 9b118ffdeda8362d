// farrier compare update-logic

#include <algorithm>
#include <cstdio>

#include "gait/schedule.hpp"
#include "trials/load_cycle.hpp"
#include "trials/update_logic_study.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/progress.hpp"
#include "report/page/html_page.hpp"
#include "report/compare/update_logic.hpp"

namespace farrier::cli {
namespace {

Result<trials::UpdateLogicRun> run_one(const robot::Robot& robot, robot::UpdateMethod method, run::InprocRun settings,
                                       const std::string& title) {
  Progress progress(title, settings.ticks);
  settings.grouping = run::Grouping::kOne;
  settings.progress = [&](Tick tick) {
    progress.update(tick);
    return !participant::stop_requested();
  };
  return trials::run_update_logic(robot, method, settings);
}

Result<report::LogicWork> measure_rig(const trials::LoadCycle& cycle, robot::UpdateMethod method, std::uint64_t seed,
                                      report::UpdateLogicResult& result) {
  run::InprocRun settings;
  settings.ticks = cycle.begin.back();
  settings.seed = seed;
  settings.load_changes = cycle.changes;
  auto ran = FARRIER_TRY(run_one(cycle.robot, method, settings, std::string("load cycle ") + robot::to_string(method)));
  for (std::size_t quarter = 0; quarter < trials::kQuarters; ++quarter) {
    result.quarter_nrmse[quarter] = trials::quarter_error(cycle, ran.rows, quarter);
  }
  return report::LogicWork{ran.looks, ran.designs, ran.accepted, ran.look_us};
}

Result<report::LogicWork> measure_trot(const robot::Robot& robot, robot::UpdateMethod method, const CompareOptions& o,
                                       report::UpdateLogicResult& result) {
  run::InprocRun settings;
  settings.ticks = run::ticks_of(o.duration_s, robot);
  settings.seed = o.seed;
  auto ran = FARRIER_TRY(run_one(robot, method, settings, std::string("trot ") + robot::to_string(method)));
  const gait::Schedule schedule(robot.plan, o.seed);
  result.tracking = report::track(robot, schedule, ran.rows, robot.loop_delay_lockstep);
  if (!report::long_enough(robot, result.tracking)) {
    return Error{kTooShort};
  }
  return report::LogicWork{ran.looks, ran.designs, ran.accepted, ran.look_us};
}

}  // namespace

int run_update_logic(const robot::Robot& robot, const CompareOptions& options) {
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"));
  if (!rig) {
    std::fprintf(stderr, "farrier compare: %s\n", config::to_string(rig.error()).c_str());
    return kBadInput;
  }
  const auto cycle = trials::make_load_cycle(rig.value());
  if (!cycle || robot.plan.gait.pattern != gait::Pattern::kTrot) {
    std::fprintf(stderr, "farrier compare: %s\n",
                 cycle ? "update-logic compares trots: give a robot that trots" : cycle.error().message.c_str());
    return kBadInput;
  }
  participant::install_signal_handlers();
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  std::vector<report::UpdateLogicResult> results;
  for (const robot::UpdateMethod method : trials::kUpdateMethods) {
    report::UpdateLogicResult result{.method = robot::to_string(method)};
    for (const bool trots : {false, true}) {
      const auto work = trots ? measure_trot(robot, method, options, result)
                              : measure_rig(cycle.value(), method, options.seed, result);
      if (!work) {
        return fail("compare", work.error().message);
      }
      (trots ? result.trot : result.rig) = work.value();
    }
    results.push_back(std::move(result));
  }
  report::add_update_logic(outcome.figures, results);
  const std::string table = report::update_logic_table(results);
  const std::string head = report::page_head(robot.name + ": update logics compared", outcome);
  const auto page = report::write_page(options.out, head + "<pre>" + table + "</pre>\n" + report::page_foot(outcome));
  if (!page) {
    return fail("compare", page.error().message);
  }
  std::fputs(table.c_str(), stdout);
  return finish_comparison(outcome, options, page.value());
}

}  // namespace farrier::cli
