// farrier compare controllers

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "trials/load_cycle.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/contenders.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/varied_study.hpp"
#include "report/figures/console.hpp"
#include "report/compare/controllers.hpp"

namespace farrier::cli {
namespace {

using Rows = std::vector<report::VaryRow>;

Result<Rows> varied_trot(const robot::Robot& robot, const CompareOptions& o) {
  const robot::Robot nominal = trials::with_varied_body(robot);
  VariedStudy study(nominal, report::kControllers, o, "controllers, varied trot");
  FARRIER_TRY(study.run());
  if (!study.long_enough()) {
    return Error{kTooShort};
  }
  return study.rows();
}

/// The cycle of Fig. 7.8 under one contender; heavy quarters count as stance, light ones as swing.
Result<report::VaryRow> load_steps(const trials::LoadCycle& cycle, report::Contender contender, std::uint64_t seed) {
  run::InprocRun run = run_of(contender, cycle.robot);
  run.ticks = cycle.begin.back();
  run.seed = seed;
  run.load_changes = cycle.changes;
  const auto errors = FARRIER_TRY(run_load_cycle(cycle, believed_by(contender, cycle.robot), run));
  return report::VaryRow{.seed = seed,
                         .contender = contender,
                         .joint = cycle.robot.joints[0].name,
                         .stance_mass_kg_or_kgm2 = cycle.loads[1].mass,
                         .stance_nrmse = errors.heavy,
                         .swing_nrmse = errors.light};
}

Result<Rows> load_steps(const CompareOptions& o) {
  const auto rig = robot::load_robot(shipped_robot("fc1d.yaml"));
  if (!rig) {
    return Error{config::to_string(rig.error())};
  }
  const auto cycle = FARRIER_TRY(trials::make_load_cycle(rig.value()));
  Rows rows;
  Progress progress("controllers, load steps", static_cast<Tick>(report::kControllers.size()) * o.seeds);
  for (int i = 0; i < o.seeds; ++i) {
    for (const report::Contender contender : report::kControllers) {
      auto row = FARRIER_TRY(load_steps(cycle, contender, o.seed + static_cast<std::uint64_t>(i)));
      rows.push_back(row);
      progress.update(static_cast<Tick>(rows.size()));
    }
  }
  return rows;
}

}  // namespace

int run_controllers(const robot::Robot& robot, const CompareOptions& options) {
  participant::install_signal_handlers();
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(robot, options.seed);
  std::string text;
  const auto add = [&](const char* test, const Result<Rows>& rows) -> Result<Done> {
    if (!rows) {
      return rows.error();
    }
    report::add_controllers(outcome.figures, test, rows.value());
    text += report::controllers_text(test, rows.value()) + "\n";
    return report::write_vary_csv(options.out + "/" + test + ".csv", rows.value());
  };
  if (auto added = add(report::kVariedTrot, varied_trot(robot, options)); !added) {
    return fail("compare", added.error().message);
  }
  if (auto added = add(report::kLoadSteps, load_steps(options)); !added) {
    return fail("compare", added.error().message);
  }
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s%s", text.c_str(), report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\nevery joint and seed: %s/%s.csv, %s.csv\n", options.json_path.c_str(), options.out.c_str(),
              report::kVariedTrot, report::kLoadSteps);
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
