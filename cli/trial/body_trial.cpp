#include "cli/trial/body_trial.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trial/body_runs.hpp"
#include "participant/loop.hpp"
#include "report/body/body_result.hpp"
#include "report/body/energy_result.hpp"
#include "report/body/supply_result.hpp"
#include "report/body/switches_result.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"
#include "trials/body/push_limit.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::cli {
namespace {

using trials::PushLimitSearch;

std::vector<trials::TrotCase> chosen_cases(const robot::Robot& robot, const BodyTrialOptions& o) {
  std::vector<trials::TrotCase> cases = trials::trot_cases(robot);
  if (o.smoke) {
    cases = trials::first_of_each_trial(cases);
  }
  std::erase_if(cases, [&o](const trials::TrotCase& one) {
    return (o.ideal && one.needs_pump()) || (!o.only.empty() && std::ranges::find(o.only, one.trial) == o.only.end());
  });
  return cases;
}

bool searches_push_limit(const BodyTrialOptions& o) {
  return !o.smoke && (o.only.empty() || std::ranges::find(o.only, PushLimitSearch::kTrial) != o.only.end());
}

/// Everything that was asked for.
struct BodyStudy {
  std::vector<trials::TrotRow> rows;
  std::size_t left = 0;  ///< runs that were begun or planned, and not made
  std::vector<trials::PushLimit> limits;
};

BodyStudy run_all(const robot::Robot& robot, const BodyTrialOptions& o, BodyRuns& runs) {
  BodyStudy study;
  const auto run = [&](const std::string& title, const std::vector<trials::TrotCase>& cases) {
    std::vector<trials::TrotRow> rows = runs.run(title, trials::jobs_of(robot, cases));
    study.left += cases.size() - rows.size();
    study.rows.insert(study.rows.end(), rows.begin(), rows.end());
    return rows;
  };
  run("trial body", chosen_cases(robot, o));
  if (!searches_push_limit(o)) {
    return study;
  }
  PushLimitSearch search(robot);
  int round = 0;
  for (auto cases = search.next(); !cases.empty() && !participant::stop_requested(); cases = search.next()) {
    search.take(run("push limit, round " + std::to_string(++round), cases));
  }
  if (!participant::stop_requested()) {
    study.limits = search.limits();
  }
  return study;
}

/// The rows of a study, judged.
struct BodyStudyResults {
  explicit BodyStudyResults(const std::vector<trials::TrotRow>& rows)
      : trials(report::body_results(rows)),
        switches(report::switches_results(rows)),
        supply(report::supply_results(rows)),
        energy(report::energy_result(rows)) {}

  std::vector<report::BodyTrialResult> trials;
  std::vector<report::SwitchesResult> switches;
  std::vector<report::SupplyTrialResult> supply;
  std::optional<report::EnergyResult> energy;
};

report::Outcome outcome_of(const robot::Robot& robot, const BodyStudy& study, const BodyStudyResults& results,
                           const std::string& not_kept) {
  report::Outcome outcome;
  outcome.command = "trial";
  outcome.run = report::run_info(robot, 1);
  report::add_body(outcome.figures, results.trials);
  report::add_switches(outcome.figures, results.switches);
  report::add_supply(outcome.figures, results.supply);
  if (results.energy) {
    report::add_energy(outcome.figures, *results.energy);
  }
  report::add_push_limits(outcome.figures, study.limits);
  for (const trials::TrotRow& row : study.rows) {
    if (!row.failure.empty()) {
      outcome.failures.push_back(key_of(row.trial, row.name) + ": " + row.failure);
    }
  }
  if (!not_kept.empty()) {
    outcome.failures.push_back("runs are not kept: " + not_kept);
  }
  if (participant::stop_requested()) {
    outcome.failures.push_back("interrupted: " + std::to_string(study.left) + " of " +
                               std::to_string(study.left + study.rows.size()) + " runs were not made");
  }
  return outcome;
}

int run_and_report(const robot::Robot& robot, const BodyTrialOptions& o) {
  const std::string kept_path = o.json_path + ".runs";
  if (auto way = make_way({o.json_path, o.go_on ? "" : kept_path}, {o.robot_path}); !way) {
    return refuse("trial", way.error().message);
  }
  participant::install_signal_handlers();
  BodyRuns runs({.kept_path = kept_path,
                 .origin = report::build_name() + ", " + report::run_info(robot, 1).configuration_hash +
                           (o.ideal ? ", ideal joints" : ""),
                 .go_on = o.go_on,
                 .joints = o.ideal ? trials::Joints::kIdeal : trials::Joints::kActuators,
                 .threads = o.threads});
  const BodyStudy study = run_all(robot, o, runs);
  const BodyStudyResults results(study.rows);
  const report::Outcome outcome = outcome_of(robot, study, results, runs.not_kept());
  const std::string rows_path = o.out + "/runs.csv";
  if (auto written = report::write_body_csv(rows_path, study.rows); !written) {
    return fail("trial", written.error().message);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trial", written.error().message);
  }
  std::printf("%s%s%s%s%s%s\n%s", report::body_text(outcome.figures, results.trials).c_str(),
              report::switches_text(results.switches).c_str(), report::supply_text(results.supply).c_str(),
              results.energy ? report::energy_text(*results.energy).c_str() : "",
              report::push_limits_text(study.limits).c_str(), report::falls_text(study.rows).c_str(),
              report::verdict_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\nevery run: %s\n", o.json_path.c_str(), rows_path.c_str());
  if (participant::stop_requested()) {
    return fail(
        "trial",
        "stopped; the figures are those of the runs that ended; the same with --continue goes on from " + kept_path);
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

int run_body_trials(const BodyTrialOptions& options) {
  BodyTrialOptions o = options;
  const auto robot = robot::load_robot(o.robot_path, {.on_ground = !o.ideal});
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (!robot.value().can_walk()) {
    return refuse("trial", robot.value().cannot_walk_error() + ", or another --robot");
  }
  if (chosen_cases(robot.value(), o).empty() && !searches_push_limit(o)) {
    return refuse("trial",
                  "no such trial has a run for this robot: "
                  "supply, low_supply, pump_stops, dead_joint, dead_hip, dead_abduction, open_valve and energy need "
                  "supply.pump in its file, "
                  "and joints that are not ideal");
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("trial", directory.error().message);
  }
  o.out = std::filesystem::absolute(o.out).lexically_normal().string();
  o.json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  return run_and_report(robot.value(), o);
}

}  // namespace farrier::cli
