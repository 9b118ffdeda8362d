// farrier compare body: force controllers of the whole robot on a ground, and what limits the best.

#include <unistd.h>

#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "participant/loop.hpp"
#include "report/body/contenders.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {

int run_body(const robot::Robot& on_bench, const CompareOptions& options) {
  if (!on_bench.can_walk()) {
    return refuse("compare", on_bench.cannot_walk_error() + ", or another --robot");
  }
  const auto on_ground = robot::load_robot(options.robot_path, {.on_ground = true});
  if (!on_ground) {
    return fail("compare", config::to_string(on_ground.error()));
  }
  participant::install_signal_handlers();
  const auto controllers = trials::force_controllers(on_ground.value(), on_bench);
  const auto limits = trials::limits_of_force(on_ground.value());
  const auto runs =
      static_cast<Tick>(2 * static_cast<std::size_t>(options.seeds) * (controllers.size() + limits.size()));
  Progress progress("compare body", runs, "runs");
  Tick ended = 0;
  const auto done = [&] {
    progress.update(++ended);
    return !participant::stop_requested();
  };
  const auto by_controller = trials::compare_on_body(controllers, options.seeds, done);
  const auto by_limit = trials::compare_on_body(limits, options.seeds, done);
  std::vector<trials::ContenderResult> all = by_controller;
  all.insert(all.end(), by_limit.begin(), by_limit.end());
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(on_ground.value(), options.seed);
  if (participant::stop_requested()) {
    outcome.failures.emplace_back("interrupted");
  }
  report::add_contenders(outcome.figures, all);
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s\n%s", report::contenders_text(by_controller).c_str(), report::contenders_text(by_limit).c_str(),
              report::verdict_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
