// farrier bench: speed as ratios in one run against what a user would pick instead.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include <unistd.h>

#include "core/text.hpp"
#include "bench/bench_control.hpp"
#include "bench/bench_estimators.hpp"
#include "bench/bench_grey_box.hpp"
#include "bench/bench_plant.hpp"
#include "bench/bench_redesign.hpp"
#include "bench/bench_riccati.hpp"
#include "bench/bench_rls.hpp"
#include "bench/bench_tick.hpp"
#include "participant/loop.hpp"
#include "process/process.hpp"
#include "bench/command/allocation_count.hpp"
#include "bench/command/bench_onlookers.hpp"
#include "cli/base/command.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/output_file.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/figures/console.hpp"

namespace farrier::cli {
namespace {

// The least the product promises; figures without a bound are for people.
constexpr double kLockstepRatio = 0.5;
constexpr double kPlantSpeedup = 20.0;
constexpr double kRiccatiSpeedup = 3.0;
constexpr double kRiccatiResidual = 1e-12;
constexpr double kRlsSpeedup = 20.0;
constexpr double kRlsDifference = 1e-12;
constexpr double kGreyBoxUs = 15.0;
constexpr double kTickUs = 50.0;
constexpr double kRedesignUs = 10.0;

const std::vector<std::string> kAll{"lockstep", "onlookers", "plant", "riccati", "control",
                                    "rls", "estimators", "greybox", "tick"};

struct BenchOptions {
  std::vector<std::string> only = kAll;
  std::string robot_path;
  Tick ticks = 4000;
  std::string out = "out/bench";
  std::string json_path;
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

Result<double> ticks_per_s(const robot::Robot& robot, const BenchOptions& o, DdsChoice dds, bool bare) {
  DdsRun run = lockstep_run(o);
  run.dds = dds;
  run.bare = bare;
  run.title = std::string(dds == DdsChoice::kCyclone ? "cyclone" : "fast") + (bare ? ", bare exchange" : ", whole stack");
  const auto outcome = run_over_dds(robot, run);
  if (!outcome) {
    return outcome.error();
  }
  return static_cast<double>(o.ticks) / outcome.value().wall_s;
}

Result<Done> bench_lockstep(const BenchOptions& o, const robot::Robot& robot, report::Figures& figures) {
  for (const DdsChoice dds : {DdsChoice::kCyclone, DdsChoice::kFast}) {
    const auto bare = ticks_per_s(robot, o, dds, true);
    if (!bare) {
      return bare.error();
    }
    const auto whole = ticks_per_s(robot, o, dds, false);
    if (!whole) {
      return whole.error();
    }
    const std::string prefix = std::string("bench.lockstep.") + (dds == DdsChoice::kCyclone ? "cyclone." : "fast.");
    figures.add(prefix + "ticks_per_s", whole.value());
    figures.add(prefix + "bare_ticks_per_s", bare.value());
    figures.add(prefix + "ratio", whole.value() / bare.value(), kLockstepRatio);
  }
  return Done{};
}

void bench_plant(report::Figures& figures) {
  std::fputs("plant: ours against CVODE at equal accuracy\n", stderr);
  const bench::PlantBench bench = bench::bench_plant(400);
  figures.add("bench.plant.us_per_tick", 1e6 * bench.ours_s_per_tick);
  figures.add("bench.plant.cvode_us_per_tick", 1e6 * bench.cvode_s_per_tick);
  figures.add("bench.plant.speedup", bench.cvode_s_per_tick / bench.ours_s_per_tick, kPlantSpeedup);
  figures.add("bench.plant.error", bench.ours_error);
  figures.add("bench.plant.cvode_error", bench.cvode_error);
}

void bench_riccati(report::Figures& figures) {
  std::fputs("riccati: doubling against the thesis's iteration and SLICOT SB02OD\n", stderr);
  const bench::RiccatiBench bench = bench::bench_riccati(50);
  figures.add("bench.riccati.doubling_us", 1e6 * bench.doubling_s);
  figures.add("bench.riccati.iteration_us", 1e6 * bench.iteration_s);
  figures.add("bench.riccati.slicot_us", 1e6 * bench.slicot_s);
  figures.add("bench.riccati.speedup_iteration", bench.iteration_s / bench.doubling_s, kRiccatiSpeedup);
  figures.add("bench.riccati.speedup_slicot", bench.slicot_s / bench.doubling_s, kRiccatiSpeedup);
  figures.add("bench.riccati.relative_residual", bench.doubling_residual, kRiccatiResidual);
}

void bench_control(report::Figures& figures) {
  std::fputs("control: one joint's control step\n", stderr);
  const bench::ControlBench bench = bench::bench_control(200'000, allocation_count);
  figures.add("bench.control.step_ns", 1e9 * bench.step_s);
  figures.add("bench.control.allocations", static_cast<double>(bench.allocations), 0.0);
}

void bench_rls(report::Figures& figures) {
  std::fputs("rls: one covariance for three rows against the thesis's 12 x 12\n", stderr);
  const bench::RlsBench bench = bench::bench_rls(4000, allocation_count);
  figures.add("bench.rls.ns_per_update", 1e9 * bench.update_s);
  figures.add("bench.rls.ns_per_update_bias", 1e9 * bench.update_bias_s);
  figures.add("bench.rls.textbook_ns_per_update", 1e9 * bench.textbook_s);
  figures.add("bench.rls.speedup", bench.textbook_s / bench.update_s, kRlsSpeedup);
  figures.add("bench.rls.difference", bench.difference, kRlsDifference);
  figures.add("bench.rls.allocations", static_cast<double>(bench.allocations), 0.0);
}

void bench_estimators(report::Figures& figures) {
  std::fputs("estimators: one joint's tick by every method, and what the gates add\n", stderr);
  const bench::EstimatorsBench bench = bench::bench_estimators(4000, allocation_count);
  for (const auto& method : bench.methods) {
    figures.add(std::string("bench.estimator.") + method.name + "_ns", 1e9 * method.take_s);
  }
  figures.add("bench.estimator.pe_gate_ns", 1e9 * bench.pe_s);
  figures.add("bench.estimator.fft_gate_ns", 1e9 * bench.fft_s);
  figures.add("bench.estimator.allocations", static_cast<double>(bench.allocations), 0.0);
}

void bench_grey_box(report::Figures& figures) {
  std::fputs("greybox: one joint's tick of the grey-box estimator, and one estimate\n", stderr);
  const bench::GreyBoxBench bench = bench::bench_grey_box(4000, allocation_count);
  figures.add("bench.greybox.tick_us", 1e6 * bench.take_s, kGreyBoxUs);
  figures.add("bench.greybox.slowest_tick_us", 1e6 * bench.take_slowest_s);
  figures.add("bench.greybox.estimate_us", 1e6 * bench.estimate_s);
  figures.add("bench.greybox.allocations", static_cast<double>(bench.allocations), 0.0);
}

Result<Done> bench_tick(const robot::Robot& robot, report::Figures& figures) {
  std::fputs("tick: every joint's control, estimation and update logic on one core, and a redesign\n", stderr);
  const auto tick = bench::bench_tick(robot, 20, allocation_count);
  if (!tick) {
    return tick.error();
  }
  const auto redesign = bench::bench_redesign(robot, 50, allocation_count);
  if (!redesign) {
    return redesign.error();
  }
  figures.add("bench.tick.us", 1e6 * tick.value().tick_s, kTickUs);
  figures.add("bench.tick.estimation_us", 1e6 * tick.value().estimation_s);
  figures.add("bench.tick.update_logic_us", 1e6 * tick.value().update_logic_s);
  figures.add("bench.tick.control_us", 1e6 * tick.value().control_s);
  figures.add("bench.tick.allocations", static_cast<double>(tick.value().allocations), 0.0);
  figures.add("bench.redesign.us", 1e6 * redesign.value().redesign_s, kRedesignUs);
  figures.add("bench.redesign.lqr_us", 1e6 * redesign.value().lqr_s);
  figures.add("bench.redesign.allocations", static_cast<double>(redesign.value().allocations), 0.0);
  return Done{};
}

int bench(BenchOptions o) {
  std::error_code refused;
  std::filesystem::create_directories(o.out, refused);
  if (refused) {
    std::fprintf(stderr, "farrier bench: --out %s: %s\n", o.out.c_str(), refused.message().c_str());
    return kBadInput;
  }
  const auto wanted = [&](const char* name) { return std::find(o.only.begin(), o.only.end(), name) != o.only.end(); };
  const std::string json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  if (const auto way = make_way(json_path); !way) {
    std::fprintf(stderr, "farrier bench: %s\n", way.error().message.c_str());
    return kBadInput;
  }
  const auto robot = robot::load_robot(o.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  report::Outcome outcome;
  outcome.command = "bench";
  outcome.run = report::run_info(0);
  if (wanted("lockstep")) {
    const auto done = bench_lockstep(o, robot.value(), outcome.figures);
    if (!done) {
      std::fprintf(stderr, "farrier bench: %s\n", done.error().message.c_str());
      return participant::stop_requested() ? participant::stop_status() : kFailed;
    }
  }
  if (wanted("onlookers")) {
    const auto done = bench_onlookers(robot.value(), lockstep_run(o), o.out, outcome.figures);
    if (!done) {
      std::fprintf(stderr, "farrier bench: %s\n", done.error().message.c_str());
      return participant::stop_requested() ? participant::stop_status() : kFailed;
    }
  }
  // What follows has nothing to clean up: Ctrl-C may end it at once.
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  if (wanted("plant")) {
    bench_plant(outcome.figures);
  }
  if (wanted("riccati")) {
    bench_riccati(outcome.figures);
  }
  if (wanted("control")) {
    bench_control(outcome.figures);
  }
  if (wanted("rls")) {
    bench_rls(outcome.figures);
  }
  if (wanted("estimators")) {
    bench_estimators(outcome.figures);
  }
  if (wanted("greybox")) {
    bench_grey_box(outcome.figures);
  }
  if (wanted("tick")) {
    if (const auto done = bench_tick(robot.value(), outcome.figures); !done) {
      std::fprintf(stderr, "farrier bench: %s\n", done.error().message.c_str());
      return kFailed;
    }
  }
  if (const auto written = report::write_json(json_path, outcome); !written) {
    std::fprintf(stderr, "farrier bench: %s\n", written.error().message.c_str());
    return kFailed;
  }
  std::fputs(report::console_text(outcome, report::wants_colour(STDOUT_FILENO)).c_str(), stdout);
  std::printf("figures: %s\n", json_path.c_str());
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
  app.add_option("--robot", o->robot_path, "robot file of the lock-step runs and of the tick")
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
  return [o] { return bench(*o); };
}

}  // namespace farrier::cli
