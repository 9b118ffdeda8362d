#include "cli/diagnose/diagnose_benchmark.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>

#include "trials/blind/outcomes_file.hpp"
#include "trials/blind/score.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "report/figures/console.hpp"
#include "core/replace_file.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {
namespace {

/// Bounds of the diagnosis, over the trials that count.
struct Bounds {
  double named = 0.95;
  double first_alone = 0.85;
  double within_tolerance = 0.85;
  double false_alarms = 0.02;
  double outside_admitted = 0.90;
  double pairs_named = 0.80;
  double confidently_wrong = 0.01;
  double median_gain = 3.0;
  double control_gain = 1.3;
  std::optional<double> outside_unknown, median_size_error;
};

Bounds bounds_of(bool electric) {
  Bounds bounds;
  if (electric) {
    bounds.named = 0.92;
    bounds.confidently_wrong = 0.005;
    bounds.outside_unknown = 0.95;
    bounds.median_size_error = 0.10;
  }
  return bounds;
}

void add_figures(report::Figures& figures, const std::vector<blind::Outcome>& outcomes, const Bounds& bounds) {
  const blind::Score s = blind::score(outcomes);
  const auto add = [&](const std::string& name, double value, std::optional<double> bound = std::nullopt) {
    if (std::isfinite(value)) {
      figures.add(name, value, bound);
    }
  };
  add("diagnose.benchmark.trials", static_cast<double>(s.trials));
  add("diagnose.benchmark.counted", static_cast<double>(s.counted));
  add("diagnose.benchmark.named", s.named, bounds.named);
  add("diagnose.benchmark.first_alone", s.first_alone, bounds.first_alone);
  add("diagnose.benchmark.within_tolerance", s.within_tolerance, bounds.within_tolerance);
  add("diagnose.benchmark.false_alarms", s.false_alarms, bounds.false_alarms);
  add("diagnose.benchmark.outside_admitted", s.outside_admitted, bounds.outside_admitted);
  add("diagnose.benchmark.outside_unknown", s.outside_unknown, bounds.outside_unknown);
  for (const auto& [size, named] : s.sets_named) {
    add("diagnose.benchmark.sets_of_" + std::to_string(size) + "_named", named,
        size == 2 ? std::optional(bounds.pairs_named) : std::nullopt);
  }
  add("diagnose.benchmark.set_names_wrong", s.set_names_wrong);
  add("diagnose.benchmark.median_size_error", s.median_size_error, bounds.median_size_error);
  add("diagnose.benchmark.median_s", s.median_s);
  add("diagnose.benchmark.confidently_wrong", s.confidently_wrong, bounds.confidently_wrong);
  add("diagnose.benchmark.median_gain", s.median_gain, bounds.median_gain);
  add("diagnose.benchmark.controlled", static_cast<double>(s.controlled));
  add("diagnose.benchmark.control_gain", s.control_gain, bounds.control_gain);
  for (const auto& [name, mine] : blind::score_by_effect(outcomes)) {
    add("diagnose.benchmark.effect." + name + ".counted", static_cast<double>(mine.counted));
    add("diagnose.benchmark.effect." + name + ".named", mine.named);
    add("diagnose.benchmark.effect." + name + ".first_alone", mine.first_alone);
    add("diagnose.benchmark.effect." + name + ".within_tolerance", mine.within_tolerance);
    add("diagnose.benchmark.effect." + name + ".control_gain", mine.control_gain);
  }
}

/// Outcomes in the order of the plans, and the reason if some are not kept for --continue; empty: all are.
struct Trials {
  std::vector<blind::Outcome> outcomes;
  std::string not_kept;
};

/// Runs the trials that are not kept. Every outcome is appended to `kept_path` as it comes, unless the path is empty.
Trials run_all(const std::vector<blind::TrialPlan>& plans, const std::vector<const robot::Joint*>& joints,
               const DiagnoseBenchmark& o, const std::string& kept_path, const std::string& origin) {
  std::map<std::size_t, blind::Outcome> kept;
  if (o.go_on) {
    kept = blind::read_outcomes(kept_path, origin, plans);
    std::fprintf(stderr, "%s: has %zu of %zu trials\n", kept_path.c_str(), kept.size(), plans.size());
  } else if (std::error_code none; !kept_path.empty()) {
    std::filesystem::remove(kept_path, none);
  }
  std::vector<std::size_t> left;
  std::vector<blind::TrialPlan> left_plans;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!kept.contains(i)) {
      left.push_back(i);
      left_plans.push_back(plans[i]);
    }
  }
  Trials trials;
  Progress bar("diagnose --benchmark", static_cast<Tick>(plans.size()), "trials");
  std::size_t done = kept.size();
  const auto fresh =
      blind::run_trials(left_plans, joints, o.threads, [&](std::size_t i, const blind::Outcome& outcome) {
        if (!kept_path.empty() && outcome.refused.empty()) {
          if (const auto written = blind::append_outcome(kept_path, origin, left[i], outcome); !written) {
            trials.not_kept = written.error().message;
          }
        }
        bar.update(static_cast<Tick>(++done));
        return !participant::stop_requested();
      });
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    kept.insert_or_assign(left[i], fresh[i]);
  }
  for (auto& [index, outcome] : kept) {
    trials.outcomes.push_back(std::move(outcome));
  }
  return trials;
}

}  // namespace

Result<TrialRobots> load_trial_robots(const std::string& folder, bool electric) {
  const std::filesystem::path in(folder);
  auto rig = robot::load_robot((in / (electric ? "electric_leg.yaml" : "fc1d.yaml")).string());
  auto legs = robot::load_robot((in / (electric ? "go1.yaml" : "hyq.yaml")).string(), {.without_effects = true});
  if (!rig || !legs) {
    return Error{config::to_string(!rig ? rig.error() : legs.error())};
  }
  return TrialRobots{std::move(rig).value(), std::move(legs).value()};
}

int run_diagnose_benchmark(const DiagnoseBenchmark& o, const std::string& robots) {
  participant::install_signal_handlers();
  for (const std::string* path : {&o.json_path, &o.confusion_path}) {
    if (!path->empty()) {
      if (auto free = make_way(*path); !free) {
        return refuse("diagnose --benchmark", free.error().message);
      }
    }
  }
  const auto loaded = load_trial_robots(robots, o.electric);
  if (!loaded) {
    return refuse("diagnose --benchmark", loaded.error().message);
  }
  const auto& [rig, legs] = loaded.value();
  const std::vector<const robot::Joint*> joints = loaded.value().joints();
  const auto plans = blind::spread(
      o.electric ? blind::all_electric_trials(joints, o.seed) : blind::all_trials(joints.size(), o.seed), o.trials);
  const std::string kept_path = o.json_path.empty() ? "" : o.json_path + ".trials";
  const std::string origin = report::build_name() + ", " + report::run_info(rig, o.seed).configuration_hash + ", " +
                             report::run_info(legs, o.seed).configuration_hash + ", seed " + std::to_string(o.seed) +
                             ", " + std::to_string(plans.size()) + " trials";
  Trials trials = run_all(plans, joints, o, kept_path, origin);
  std::vector<blind::Outcome>& outcomes = trials.outcomes;
  report::Outcome outcome;
  outcome.command = "diagnose";
  outcome.run = report::run_info(rig, o.seed);
  const auto not_run = std::ranges::count(outcomes, blind::kNotRun, &blind::Outcome::refused);
  if (not_run > 0) {
    outcome.failures.push_back("interrupted: " + std::to_string(not_run) + " of " + std::to_string(outcomes.size()) +
                               " trials were not run");
    std::erase_if(outcomes, [](const blind::Outcome& trial) { return trial.refused == blind::kNotRun; });
  }
  if (!trials.not_kept.empty()) {
    outcome.failures.push_back("trials are not kept: " + trials.not_kept);
  }
  for (const blind::Outcome& trial : outcomes) {
    if (!trial.refused.empty()) {
      outcome.failures.push_back("a trial could not be made: " + trial.refused);
    }
  }
  add_figures(outcome.figures, outcomes, bounds_of(o.electric));
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (!o.json_path.empty()) {
    if (auto written = report::write_json(o.json_path, outcome); !written) {
      return fail("diagnose --benchmark", written.error().message);
    }
  }
  if (not_run > 0) {
    return fail("diagnose --benchmark",
                "stopped; the figures are those of the trials that were run" +
                    (kept_path.empty() ? "" : "; the same with --continue goes on from " + kept_path));
  }
  if (!o.confusion_path.empty()) {
    if (auto written = replace_file(o.confusion_path, blind::confusion_page(outcomes)); !written) {
      return fail("diagnose --benchmark", written.error().message);
    }
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
