// farrier trot --experiment fig7.8

#include <cstdio>

#include "lab/load_cycle.hpp"
#include "tools/cli/command.hpp"
#include "tools/cli/experiment.hpp"
#include "tools/report/load_cycle.hpp"

namespace farrier::cli {
namespace {

/// Of the valve's nominal current, where the robot file asks for none: the cycle's reference alone excites nothing
/// above 10 Hz.
constexpr double kDither_percent = 0.1;

struct Case {
  const char* name;
  const char* title;
  supervisor::Design design;
  bool knows_loads;
  bool dithers;
};
constexpr Case kCases[] = {
    {"fixed", "Gains fixed, designed for the light load", supervisor::Design::kSwing, false, false},
    {"adaptive", "Gains adaptive", supervisor::Design::kAdaptive, false, true},
    {"true_load", "Gains for the true load, switched exactly", supervisor::Design::kSwing, true, false},
    {"true_load_dithered", "Gains for the true load, switched exactly, dithered", supervisor::Design::kSwing, true,
     true}};

robot::Robot with_dither(robot::Robot robot, bool dithers) {
  double& percent = robot.joints[0].dither_percent;
  percent = dithers ? (percent > 0.0 ? percent : kDither_percent) : 0.0;
  return robot;
}

}  // namespace

int run_load_cycle(const robot::Robot& rig, const TrotOptions& options) {
  const auto made = lab::make_load_cycle(rig);
  if (!made) {
    std::fprintf(stderr, "farrier trot: %s\n", made.error().message.c_str());
    return kBadInput;
  }
  const lab::LoadCycle& cycle = made.value();
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(cycle.robot, options.seed);
  std::vector<report::LoadCycleRun> runs;
  for (const Case& one : kCases) {
    lab::InprocRun settings;
    settings.ticks = cycle.begin.back();
    settings.seed = options.seed;
    settings.design = one.design;
    settings.load_changes = cycle.changes;
    if (one.knows_loads) {
      settings.known_loads = cycle.changes;
    }
    auto ran = run_experiment(with_dither(cycle.robot, one.dithers), settings,
                              options.out + "/trace_" + one.name + ".csv", std::string("fig7.8 ") + one.name);
    if (!ran) {
      return fail_experiment(ran.error());
    }
    add_failures(outcome, ran.value(), one.name);
    runs.push_back({one.name, one.title, std::move(ran.value().rows), std::move(ran.value().result.gains)});
  }
  const report::LoadCyclePlan plan{cycle.robot, cycle.loads, cycle.begin};
  report::add_load_cycle(outcome.figures, plan, runs);
  const auto page = report::write_load_cycle_report(options.out, outcome, plan, runs);
  if (!page) {
    return fail_experiment(page.error());
  }
  std::printf("load %g, %g, %g, %g kg, friction %g, %g, %g, %g Ns/m, %g s each after %g s of lead-in; dither %g %%\n",
              cycle.loads[0].mass, cycle.loads[1].mass, cycle.loads[2].mass, cycle.loads[3].mass,
              cycle.loads[0].damping, cycle.loads[1].damping, cycle.loads[2].damping, cycle.loads[3].damping,
              lab::kQuarter_s, cycle.robot.plan.gait.lead_in_s,
              with_dither(cycle.robot, true).joints[0].dither_percent);
  return finish_experiment(outcome, options, page.value());
}

}  // namespace farrier::cli
