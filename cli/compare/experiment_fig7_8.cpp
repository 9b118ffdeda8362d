// farrier trot --experiment fig7.8

#include <cstdio>

#include "trials/load_cycle.hpp"
#include "cli/base/command.hpp"
#include "cli/compare/experiment.hpp"
#include "report/compare/load_cycle.hpp"

namespace farrier::cli {

int run_load_cycle(const robot::Robot& rig, const TrotOptions& options) {
  const auto made = trials::make_load_cycle(rig);
  if (!made) {
    std::fprintf(stderr, "farrier trot: %s\n", made.error().message.c_str());
    return kBadInput;
  }
  const trials::LoadCycle& cycle = made.value();
  report::Outcome outcome;
  outcome.command = "trot";
  outcome.run = report::run_info(cycle.robot, options.seed);
  std::vector<report::LoadCycleRun> runs;
  for (const trials::LoadCycleCase& one :
       {trials::kFixedCase, trials::kAdaptiveCase, trials::kTrueLoadCase, trials::kTrueLoadDitheredCase,
        trials::kGreyBoxCase, trials::kGreyBoxNoiselessCase}) {
    auto ran = run_experiment(trials::robot_of(cycle, one), trials::run_of(cycle, one, options.seed),
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
              trials::kQuarter_s, cycle.robot.plan.gait.lead_in_s,
              trials::robot_of(cycle, trials::kAdaptiveCase).joints[0].dither_percent);
  return finish_experiment(outcome, options, page.value());
}

}  // namespace farrier::cli
