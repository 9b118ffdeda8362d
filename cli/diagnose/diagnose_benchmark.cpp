#include "cli/diagnose/diagnose_benchmark.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "trials/blind/calibration.hpp"
#include "trials/blind/outcomes_file.hpp"
#include "trials/blind/score.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "cli/diagnose/diagnose_benchmark_figures.hpp"
#include "report/figures/console.hpp"
#include "core/replace_file.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {
namespace {

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
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!kept.contains(i)) {
      left.push_back(i);
    }
  }
  std::vector<blind::TrialPlan> left_plans;
  std::ranges::transform(left, std::back_inserter(left_plans), [&](std::size_t i) { return plans[i]; });
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

/// The joints that trials are made of.
std::vector<const robot::Joint*> joints_of(const TrialRobots& robots, bool healthy) {
  if (!healthy) {
    return robots.joints();
  }
  std::vector<const robot::Joint*> all;
  for (const robot::Joint& joint : robots.legs.joints) {
    all.push_back(&joint);
  }
  return all;
}

std::vector<blind::TrialPlan> plans_of(const DiagnoseBenchmark& o, const std::vector<const robot::Joint*>& joints) {
  if (o.healthy) {
    return blind::healthy_trials(joints.size(), static_cast<std::size_t>(o.trials > 0 ? o.trials : kHealthyRobots),
                                 o.seed);
  }
  const auto all = [&](std::uint64_t seed) {
    return o.electric ? blind::all_electric_trials(joints, seed) : blind::all_trials(joints.size(), seed);
  };
  std::vector<blind::TrialPlan> plans = all(o.seed);
  if (!o.calibration_path.empty()) {
    const std::vector<blind::TrialPlan> again = all(o.seed + plans.size());
    plans.insert(plans.end(), again.begin(), again.end());
  }
  return blind::mixed(plans, o.trials);
}

/// Writes the map of confidences that the trials give, with its source.
Result<Done> calibrate(const std::vector<blind::Outcome>& outcomes, const DiagnoseBenchmark& o) {
  const auto map = blind::fitted_map(outcomes);
  if (!map) {
    return Error{"a map of confidences needs right and wrong names: run more trials"};
  }
  const std::string source = "Fitted by farrier diagnose --benchmark" +
                             std::string(o.electric ? " --actuator electric" : "") + " --calibrate, seed " +
                             std::to_string(o.seed) + ", " + std::to_string(outcomes.size()) + " trials.";
  return replace_file(o.calibration_path, blind::map_text(*map, source));
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
  if (!o.calibration_path.empty() && o.seed < blind::kCalibrationSeed) {
    return refuse("diagnose --benchmark", "--calibrate needs a --seed of " + std::to_string(blind::kCalibrationSeed) +
                                              " or more: lower ones are those that test the confidences");
  }
  for (const std::string* path : {&o.json_path, &o.confusion_path, &o.calibration_path}) {
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
  const std::vector<const robot::Joint*> joints = joints_of(loaded.value(), o.healthy);
  const auto plans = plans_of(o, joints);
  const std::string kept_path = o.json_path.empty() ? "" : o.json_path + ".trials";
  const std::string origin = report::build_name() + ", " + report::run_info(rig, o.seed).configuration_hash + ", " +
                             report::run_info(legs, o.seed).configuration_hash + ", seed " + std::to_string(o.seed) +
                             (o.healthy ? ", healthy" : "");
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
  if (o.healthy) {
    add_healthy_figures(outcome.figures, outcomes, joints.size());
  } else {
    add_benchmark_figures(outcome.figures, outcomes, o.electric);
  }
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
  if (!o.calibration_path.empty()) {
    if (auto written = calibrate(outcomes, o); !written) {
      return fail("diagnose --benchmark", written.error().message);
    }
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
