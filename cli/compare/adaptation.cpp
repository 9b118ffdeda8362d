// farrier compare adaptation: plants that no design knows, under the whole robot on a ground.

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/compare/comparison.hpp"
#include "cli/trial/body_runs.hpp"
#include "core/text.hpp"
#include "participant/loop.hpp"
#include "report/body/adaptation_result.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {
namespace {

using trials::kStudyConditions;

/// Seeds of a row: more where fixed designs fall.
int seeds_of(const trials::PlantRow& row, const CompareOptions& o) { return row.decides ? 2 * o.seeds + 2 : o.seeds; }

bool is_chosen(const std::vector<std::string>& names, const std::string& name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

/// Why a name is refused; empty: all are known.
std::string unknown_of(const char* option, const std::vector<std::string>& names,
                       const std::vector<std::string>& known) {
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) == known.end()) {
      return std::string(option) + ": there is no " + name + ": give one of " + join(known, ", ");
    }
  }
  return "";
}

std::string unknown_of(const CompareOptions& o, const std::vector<trials::StudyDesign>& designs) {
  const auto names_of = [](const auto& all) {
    std::vector<std::string> names;
    for (const auto& each : all) {
      names.emplace_back(each.name);
    }
    return names;
  };
  std::string why = unknown_of("--rows", o.rows, names_of(trials::plant_rows()));
  why = why.empty() ? unknown_of("--conditions", o.conditions, names_of(kStudyConditions)) : why;
  return why.empty() ? unknown_of("--designs", o.designs, names_of(designs)) : why;
}

/// The designs that were asked for, with the gait of every condition.
struct Contenders {
  std::vector<trials::StudyDesign> designs;
  std::vector<std::vector<robot::Robot>> robots;  ///< by design and condition
};

Contenders contenders_of(std::vector<trials::StudyDesign> designs, const CompareOptions& o) {
  Contenders all;
  for (trials::StudyDesign& design : designs) {
    if (is_chosen(o.designs, design.name)) {
      std::vector<robot::Robot>& robots = all.robots.emplace_back();
      for (const trials::StudyCondition& condition : kStudyConditions) {
        robots.push_back(trials::with_gait(design.robot, condition));
      }
      all.designs.push_back(std::move(design));
    }
  }
  return all;
}

std::vector<trials::TrotJob> jobs_of(const Contenders& contenders, const trials::PlantRow& row,
                                     const CompareOptions& o) {
  std::vector<trials::TrotJob> jobs;
  const int seeds = seeds_of(row, o);
  for (std::size_t condition = 0; condition < kStudyConditions.size(); ++condition) {
    for (std::size_t design = 0; design < contenders.designs.size(); ++design) {
      for (int seed = 1; is_chosen(o.conditions, kStudyConditions[condition].name) && seed <= seeds; ++seed) {
        jobs.push_back({&contenders.robots[design][condition],
                        trials::study_case(contenders.designs[design], row, kStudyConditions[condition],
                                           static_cast<std::uint64_t>(seed))});
      }
    }
  }
  return jobs;
}

int search(const robot::Robot& on_ground, const CompareOptions& o, BodyRuns& runs) {
  for (const bool with_observer : {false, true}) {
    if (!is_chosen(o.designs, with_observer ? trials::kObserver : trials::kTuned)) {
      continue;
    }
    trials::FixedSearch search(on_ground, with_observer);
    const std::string title = with_observer ? "search with observer" : "search";
    for (auto jobs = search.next(); !jobs.empty(); jobs = search.next()) {
      search.take(runs.run(title + ", round " + std::to_string(search.round() + 1), jobs));
      if (participant::stop_requested()) {
        return fail("compare", "stopped; the same with --continue goes on");
      }
      std::printf("%s, after round %d\n%s\n", title.c_str(), search.round(),
                  report::search_text(search.candidates()).c_str());
      std::fflush(stdout);
    }
  }
  return kPassed;
}

}  // namespace

int run_adaptation(const robot::Robot& on_bench, const CompareOptions& o) {
  if (!on_bench.can_walk()) {
    return refuse("compare", on_bench.cannot_walk_error() + ", or another --robot");
  }
  const auto on_ground = robot::load_robot(o.robot_path, {.on_ground = true});
  if (!on_ground) {
    return fail("compare", config::to_string(on_ground.error()));
  }
  const auto with_rls =
      robot::load_robot(o.robot_path, {.estimator = on_bench.file.joints.front().second.estimator, .on_ground = true});
  if (!with_rls) {
    return fail("compare", config::to_string(with_rls.error()));
  }
  auto designs =
      o.noise ? trials::noise_designs(on_ground.value()) : trials::study_designs(on_ground.value(), with_rls.value());
  if (const std::string unknown = unknown_of(o, designs); !unknown.empty()) {
    return refuse("compare", unknown);
  }
  const std::string kept_path = o.json_path + ".runs";
  if (auto way = make_way({o.go_on ? "" : kept_path}, {o.robot_path}); !way) {
    return refuse("compare", way.error().message);
  }
  participant::install_signal_handlers();
  BodyRuns runs({.kept_path = kept_path,
                 .origin = report::build_name() + ", " + report::run_info(on_ground.value(), 1).configuration_hash +
                           ", adaptation",
                 .go_on = o.go_on,
                 .threads = o.threads});
  if (o.search) {
    return search(on_ground.value(), o, runs);
  }
  const Contenders contenders = contenders_of(std::move(designs), o);
  std::vector<trials::TrotRow> all;
  std::size_t left = 0;
  for (const trials::PlantRow& row : trials::plant_rows()) {
    if (!is_chosen(o.rows, row.name)) {
      continue;
    }
    const auto jobs = jobs_of(contenders, row, o);
    const auto ran = participant::stop_requested() ? std::vector<trials::TrotRow>{} : runs.run(row.name, jobs);
    left += jobs.size() - ran.size();
    all.insert(all.end(), ran.begin(), ran.end());
    std::printf("%s: %s\n%s\n", row.name, row.sentence,
                report::adaptation_text(report::adaptation_rows(contenders.designs, ran)).c_str());
    std::fflush(stdout);
  }
  const auto rows = report::adaptation_rows(contenders.designs, all);
  report::Outcome outcome;
  outcome.command = "compare";
  outcome.run = report::run_info(on_ground.value(), o.seed);
  report::add_adaptation(outcome.figures, rows);
  for (const trials::TrotRow& run : all) {
    if (!run.failure.empty()) {
      outcome.failures.push_back(key_of(run.trial, run.name) + ": " + run.failure);
    }
  }
  if (!runs.not_kept().empty()) {
    outcome.failures.push_back("runs are not kept: " + runs.not_kept());
  }
  if (left > 0) {
    outcome.failures.push_back("interrupted: " + std::to_string(left) +
                               " runs were not made; the same with --continue goes on from " + kept_path);
  }
  if (auto written = report::write_json(o.json_path, outcome); !written) {
    return fail("compare", written.error().message);
  }
  std::printf("%s\n%s", report::adaptation_text(rows).c_str(),
              report::verdict_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str());
  std::printf("figures: %s\n", o.json_path.c_str());
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace farrier::cli
