#include "cli/trial/body_trial.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "participant/loop.hpp"
#include "report/body/body_result.hpp"
#include "report/body/body_rows_file.hpp"
#include "report/figures/console.hpp"
#include "report/figures/outcome.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::cli {
namespace {

/// Rows by the name of their case, and the reason if some are not kept for --continue; empty: all are.
struct BodyRuns {
  std::map<std::string, trials::TrotRow> rows;
  std::string not_kept;
};

std::string key_of(const std::string& trial, const std::string& name) { return trial + ": " + name; }

std::vector<trials::TrotCase> chosen_cases(const robot::Robot& robot, const BodyTrialOptions& o) {
  std::vector<trials::TrotCase> cases = trials::trot_cases(robot);
  if (o.smoke) {
    cases = trials::first_of_each_trial(cases);
  }
  std::erase_if(cases, [&o](const trials::TrotCase& one) {
    return !o.only.empty() && std::ranges::find(o.only, one.trial) == o.only.end();
  });
  return cases;
}

void take_over(const std::string& path, const std::string& origin, const std::vector<trials::TrotCase>& cases,
               BodyRuns& runs) {
  for (trials::TrotRow& row : report::read_rows(path, origin)) {
    const bool wanted = std::ranges::any_of(
        cases, [&row](const trials::TrotCase& one) { return one.trial == row.trial && one.name == row.name; });
    if (wanted) {
      runs.rows.insert_or_assign(key_of(row.trial, row.name), std::move(row));
    }
  }
  std::fprintf(stderr, "%s: has %zu of %zu runs\n", path.c_str(), runs.rows.size(), cases.size());
}

BodyRuns run_all(const robot::Robot& robot, const BodyTrialOptions& o, const std::vector<trials::TrotCase>& cases,
                 const std::string& kept_path, const std::string& origin) {
  BodyRuns runs;
  if (o.go_on) {
    take_over(kept_path, origin, cases, runs);
  }
  std::vector<trials::TrotCase> left;
  std::ranges::copy_if(cases, std::back_inserter(left), [&runs](const trials::TrotCase& one) {
    return !runs.rows.contains(key_of(one.trial, one.name));
  });
  Progress bar("trial body", static_cast<Tick>(cases.size()), "runs");
  const auto done = [&](const trials::TrotRow& row) {
    if (row.failure.empty()) {
      if (const auto written = report::append_row(kept_path, origin, row); !written) {
        runs.not_kept = written.error().message;
      }
    }
    runs.rows.insert_or_assign(key_of(row.trial, row.name), row);
    bar.update(static_cast<Tick>(runs.rows.size()));
  };
  trials::run_trot_cases(robot, left, o.threads, done, [] { return !participant::stop_requested(); });
  return runs;
}

/// Rows in the order of their cases.
std::vector<trials::TrotRow> in_order(const std::vector<trials::TrotCase>& cases, const BodyRuns& runs) {
  std::vector<trials::TrotRow> rows;
  for (const trials::TrotCase& one : cases) {
    if (const auto row = runs.rows.find(key_of(one.trial, one.name)); row != runs.rows.end()) {
      rows.push_back(row->second);
    }
  }
  return rows;
}

report::Outcome outcome_of(const robot::Robot& robot, const std::vector<trials::TrotRow>& rows,
                           const std::vector<report::BodyTrialResult>& results, const std::string& not_kept) {
  report::Outcome outcome;
  outcome.command = "trial";
  outcome.run = report::run_info(robot, 1);
  report::add_body(outcome.figures, results);
  for (const trials::TrotRow& row : rows) {
    if (!row.failure.empty()) {
      outcome.failures.push_back(key_of(row.trial, row.name) + ": " + row.failure);
    }
  }
  if (!not_kept.empty()) {
    outcome.failures.push_back("runs are not kept: " + not_kept);
  }
  return outcome;
}

int run_and_report(const robot::Robot& robot, const BodyTrialOptions& o) {
  const std::string kept_path = o.json_path + ".runs";
  if (auto way = make_way({o.json_path, o.go_on ? "" : kept_path}, {o.robot_path}); !way) {
    return refuse("trial", way.error().message);
  }
  participant::install_signal_handlers();
  const std::vector<trials::TrotCase> cases = chosen_cases(robot, o);
  const std::string origin = report::build_name() + ", " + report::run_info(robot, 1).configuration_hash;
  const BodyRuns runs = run_all(robot, o, cases, kept_path, origin);
  const std::vector<trials::TrotRow> rows = in_order(cases, runs);
  const std::vector<report::BodyTrialResult> results = report::body_results(rows);
  report::Outcome outcome = outcome_of(robot, rows, results, runs.not_kept);
  if (rows.size() < cases.size()) {
    outcome.failures.push_back("interrupted: " + std::to_string(cases.size() - rows.size()) + " of " +
                               std::to_string(cases.size()) + " runs were not made");
  }
  const std::string rows_path = o.out + "/runs.csv";
  if (auto written = report::write_body_csv(rows_path, rows); !written) {
    return fail("trial", written.error().message);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("trial", written.error().message);
  }
  std::printf("%s\n%s", report::body_text(outcome.figures, results).c_str(),
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
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  if (!robot.value().body || !robot.value().locomotion) {
    return refuse("trial",
                  robot.value().name +
                      " cannot walk on a ground: give body.trunk and locomotion in its file, or another --robot");
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
