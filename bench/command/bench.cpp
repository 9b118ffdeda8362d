// farrier bench: speed as ratios in one run against what a user would pick instead.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>

#include <unistd.h>

#include "core/text.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "bench/command/body_part.hpp"
#include "bench/command/bench_onlookers.hpp"
#include "bench/command/bench_ros.hpp"
#include "bench/command/computed_parts.hpp"
#include "bench/command/parts.hpp"
#include "cli/base/command.hpp"
#include "core/median.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {
namespace {

// The least the product promises.
constexpr double kLockstepRatio = 0.5;
constexpr double kBodyRatio = 0.7;
constexpr int kBodyPairs = 3;

const std::vector<std::string> kAll{"lockstep", "body_lockstep", "onlookers",  "ros",     "plant", "riccati",
                                    "control",  "rls",           "estimators", "greybox", "tick",  "body"};

/// All that this build can measure.
std::vector<std::string> possible() {
  std::vector<std::string> names = kAll;
  if (!has_body_part()) {
    std::erase(names, "body_lockstep");
    std::erase(names, "body");
  }
  return names;
}

struct BenchOptions {
  std::vector<std::string> only = possible();
  std::string robot_path;
  Tick ticks = 4000;
  std::string out = "out/bench";
  std::string json_path;
  bool go_on = false;
};

DdsRun lockstep_run(const BenchOptions& o) {
  DdsRun run;
  run.common.robot_path = o.robot_path;
  run.common.ticks = o.ticks;
  run.common.session = static_cast<std::uint64_t>(::getpid());
  run.executables = processes_directory();
  run.log_directory = o.out + "/log";
  return run;
}

Result<double> ticks_per_s(const robot::Robot& robot, const BenchOptions& o, DdsChoice dds, bool bare,
                           participant::World world = participant::World::kBench) {
  DdsRun run = lockstep_run(o);
  run.dds = dds;
  run.common.world = world;
  run.bare = bare;
  run.title = std::string(to_string(dds)) + (participant::is_on_ground(world) ? ", body" : "") +
              (bare ? ", bare exchange" : ", whole stack");
  const auto outcome = FARRIER_TRY(run_over_dds(robot, run));
  return static_cast<double>(o.ticks) / outcome.wall_s;
}

Result<Done> bench_lockstep(const BenchOptions& o, const robot::Robot& robot, DdsChoice dds, report::Figures& figures) {
  const auto bare = FARRIER_TRY(ticks_per_s(robot, o, dds, true));
  const std::string prefix = std::string("bench.lockstep.") + to_string(dds) + ".";
  figures.add(prefix + "bare_ticks_per_s", bare);
  const auto whole = FARRIER_TRY(ticks_per_s(robot, o, dds, false));
  figures.add(prefix + "ticks_per_s", whole);
  figures.add(prefix + "ratio", whole / bare, kLockstepRatio);
  return Done{};
}

/// The same of a body on a ground: medians of pairs of runs.
Result<Done> bench_body_lockstep(const BenchOptions& o, const robot::Robot& robot, DdsChoice dds,
                                 report::Figures& figures) {
  std::vector<double> whole, bare, ratios;
  for (int pair = 0; pair < kBodyPairs; ++pair) {
    bare.push_back(FARRIER_TRY(ticks_per_s(robot, o, dds, true, participant::World::kBody)));
    whole.push_back(FARRIER_TRY(ticks_per_s(robot, o, dds, false, participant::World::kBody)));
    ratios.push_back(whole.back() / bare.back());
  }
  const std::string prefix = std::string("bench.lockstep.") + to_string(dds) + ".";
  figures.add(prefix + "body_bare_ticks_per_s", median(bare));
  figures.add(prefix + "body_ticks_per_s", median(whole));
  figures.add(prefix + "body_ratio", median(ratios), kBodyRatio);
  return Done{};
}

/// Said by end_at_once().
std::string last_words;

extern "C" void end_at_once(int signal) {
  static_cast<void>(!::write(STDERR_FILENO, last_words.data(), last_words.size()));
  ::_exit(128 + signal);
}

/// A part that has nothing to clean up: Ctrl-C may end it at once.
Part interruptible(Part part) {
  return {part.name, [measure = part.measure](report::Figures& figures) {
            std::signal(SIGINT, end_at_once);
            std::signal(SIGTERM, end_at_once);
            return measure(figures);
          }};
}

/// The parts of --only, those that start processes first. `o` and `robot` outlive them.
std::vector<Part> parts_of(const BenchOptions& o, const robot::Robot& robot) {
  std::vector<Part> parts;
  const auto add = [&](const char* only, std::string name, std::function<Result<Done>(report::Figures&)> measure) {
    if (std::ranges::find(o.only, only) != o.only.end()) {
      parts.push_back({std::move(name), std::move(measure)});
    }
  };
  constexpr std::array kVendors{DdsChoice::kCyclone, DdsChoice::kFast};
  for (const DdsChoice dds : kVendors) {
    add("lockstep", std::string("lockstep ") + to_string(dds),
        [&o, &robot, dds](report::Figures& figures) { return bench_lockstep(o, robot, dds, figures); });
    if (robot.can_walk()) {
      add("body_lockstep", std::string("body_lockstep ") + to_string(dds),
          [&o, &robot, dds](report::Figures& figures) { return bench_body_lockstep(o, robot, dds, figures); });
    }
  }
  for (const DdsChoice dds : kVendors) {
    DdsRun plain = lockstep_run(o);
    plain.dds = dds;
    add("onlookers", std::string("onlookers ") + to_string(dds) + " in lock-step",
        [&o, &robot, plain](report::Figures& figures) { return bench_watched(robot, plain, o.out, figures); });
    add("onlookers", std::string("onlookers ") + to_string(dds) + " in real time",
        [&o, &robot, plain](report::Figures& figures) { return bench_beside(robot, plain, o.out, figures); });
  }
  add("ros", "ros in real time",
      [&robot, plain = lockstep_run(o)](report::Figures& figures) { return bench_ros(robot, plain, figures); });
  for (const ComputedPart& computed : computed_parts(robot)) {
    const Part part = interruptible(computed.part);
    add(computed.only, part.name, part.measure);
  }
  return parts;
}

/// The conditions beside the parts on which the figures depend.
std::string origin_of(const BenchOptions& o, const robot::Robot& robot) {
  const report::RunInfo run = report::run_info(robot, 0);
  return report::build_name() + ", " + run.machine.cpu_model + ", " + robot.name + " " + run.configuration_hash + ", " +
         std::to_string(o.ticks) + " ticks";
}

int bench(BenchOptions o) {
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("bench", directory.error().message);
  }
  const std::string json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  const std::string parts_path = json_path + ".parts";
  if (const auto way = make_way({json_path, o.go_on ? "" : parts_path}, {o.robot_path}); !way) {
    return refuse("bench", way.error().message);
  }
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  PartsRun run(parts_path, origin_of(o, robot.value()));
  if (o.go_on) {
    const std::vector<std::string> kept = run.take_over();
    std::fprintf(
        stderr, "%s: %s\n", parts_path.c_str(),
        kept.empty() ? "no part of this build, robot, computer and --ticks" : ("has " + join(kept, ", ")).c_str());
  }
  const std::string goes_on = parts_path + " keeps what was measured; the same with --continue goes on from there";
  last_words = "\nfarrier bench: interrupted; " + goes_on + "\n";
  report::Outcome outcome;
  outcome.command = "bench";
  outcome.run = report::run_info(0);
  run.run(parts_of(o, robot.value()), outcome, participant::stop_requested);
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  if (const auto written = report::write_json(json_path, outcome); !written) {
    return fail("bench", written.error().message + "; " + goes_on);
  }
  std::printf("figures: %s\n", json_path.c_str());
  if (participant::stop_requested()) {
    return fail("bench", "interrupted; " + goes_on);
  }
  if (!outcome.failures.empty()) {
    return fail("bench", "a part failed; " + goes_on);
  }
  return outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_bench(CLI::App& app) {
  auto o = std::make_shared<BenchOptions>();
  o->robot_path = shipped_robot("hyq.yaml");
  app.add_option("--only", o->only, "what to measure, of " + join(kAll, ", "))
      ->delimiter(',')
      ->check(CLI::IsMember(kAll))
      ->type_name("<names>")
      ->default_str("all");
  app.add_option("--robot", o->robot_path, "robot file of the lock-step runs, of the tick and of the body")
      ->type_name("<file>")
      ->default_str("hyq.yaml, as shipped");
  app.add_option("--ticks", o->ticks, "length of each lock-step run; half of it beside who looks on")
      ->check(between(100, 1e6))
      ->type_name("<n>")
      ->capture_default_str();
  app.add_option("--out", o->out, "directory for the figures and the logs")->type_name("<dir>")->capture_default_str();
  app.add_option("--json", o->json_path, "where the figures go")
      ->type_name("<file>")
      ->default_str("figures.json in --out");
  app.add_flag(
      "--continue", o->go_on,
      "measures the parts that failed or were not reached; the others are taken from the .parts file beside the "
      "figures, if build, robot, computer and --ticks are the same");
  return [o] { return bench(*o); };
}

}  // namespace farrier::cli
