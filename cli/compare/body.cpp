// farrier compare body: force controllers of the whole robot on a ground, and what limits the best.

#include <unistd.h>

#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/progress.hpp"
#include "cli/compare/comparison.hpp"
#include "participant/loop.hpp"
#include "report/body/contenders.hpp"
#include "report/body/estimators.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {
namespace {

int compare_estimators(const robot::Robot& on_ground, const CompareOptions& options) {
  const auto with_grey_box = robot::load_robot(options.robot_path, {.estimator = "greybox", .on_ground = true});
  if (!with_grey_box) {
    return fail("compare", config::to_string(with_grey_box.error()));
  }
  const auto adapting = trials::adapting_robots(on_ground, with_grey_box.value());
  Progress progress("compare body",
                    static_cast<Tick>(2 * static_cast<std::size_t>(options.seeds) * adapting.size()) + 2, "runs");
  Tick ended = 0;
  const auto goes_on = [] { return !participant::stop_requested(); };
  const auto done = [&] {
    progress.update(++ended);
    return goes_on();
  };
  const auto scores = trials::score_estimators(on_ground, with_grey_box.value(), options.seed, goes_on);
  done();
  const auto scores_ideal = trials::score_estimators(
      trials::with_ideal_valves(on_ground), trials::with_ideal_valves(with_grey_box.value()), options.seed, goes_on);
  done();
  const auto adapted = trials::adapt_on_body(adapting, options.seeds, done);
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(on_ground, options.seed);
  if (participant::stop_requested()) {
    outcome.failures.emplace_back("interrupted");
  }
  report::add_estimators(outcome.figures, "estimator", scores);
  report::add_estimators(outcome.figures, "estimator_ideal_valve", scores_ideal);
  report::add_adapting(outcome.figures, adapted);
  if (auto written = report::write_json(options.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\nwith ideal valves\n%s\n%s\n%s", report::estimators_text(scores).c_str(),
              report::estimators_text(scores_ideal).c_str(), report::adapting_text(adapted).c_str(),
              report::verdict_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", options.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

int run_body(const robot::Robot& on_bench, const CompareOptions& options) {
  if (!on_bench.can_walk()) {
    return refuse("compare", on_bench.cannot_walk_error() + ", or another --robot");
  }
  const auto on_ground = robot::load_robot(options.robot_path, {.on_ground = true});
  if (!on_ground) {
    return fail("compare", config::to_string(on_ground.error()));
  }
  participant::install_signal_handlers();
  if (options.estimators) {
    return compare_estimators(on_ground.value(), options);
  }
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
