#include "cli/trot/in_process.hpp"

#include "core/median.hpp"
#include "run/inproc_run.hpp"
#include "participant/loop.hpp"
#include "robot/keys.hpp"
#include "cli/base/progress.hpp"
#include "cli/trot/trot_run.hpp"

namespace farrier::cli {
namespace {

/// A run beside under LQR, whatever the robot file says, and how its joints tracked.
Result<report::Tracking> track_beside(robot::Robot robot, const TrotOptions& o, supervisor::Design design,
                                      const std::string& trace_path, const std::string& title) {
  for (robot::Joint& joint : robot.joints) {
    joint.kind = control::Kind::kLqr;
  }
  auto run = FARRIER_TRY(run_in_process(robot, o, design, trace_path, title));
  return tracking_of(robot, run, trace_path, o.seed, robot.loop_delay_lockstep);
}

}  // namespace

Result<RunOutcome> run_in_process(const robot::Robot& robot, const TrotOptions& o, supervisor::Design design,
                                  const std::string& trace_path, const std::string& title, const Extras& extras) {
  participant::install_signal_handlers();
  run::InprocRun run;
  run.grouping = grouping_of(o);
  run.ticks = run::ticks_of(o.duration_s, robot);
  run.seed = o.seed;
  run.design = design;
  run.trace_path = trace_path;
  run.simulated = extras.world;
  run.world = o.world;
  run.scene_path = o.scene_path;
  run.velocity = o.velocity;
  run.record_path = extras.record_path;
  run.record_facts = record_facts(robot, o);
  RunOutcome outcome;
  run.sink = [&outcome](const trace::TraceRow& row) { outcome.rows.push_back(row); };
  Progress progress(title, run.ticks);
  run.progress = [&](Tick tick) {
    progress.update(tick);
    return !participant::stop_requested();
  };
  const SteadyTime begin = std::chrono::steady_clock::now();
  auto result = FARRIER_TRY(run::run_inproc(robot, run));
  outcome.members = run::plan_members(robot, run.grouping);
  outcome.hellos = std::move(result.hellos);
  outcome.healths = std::move(result.healths);
  outcome.events = std::move(result.events);
  outcome.decisions = std::move(result.decisions);
  outcome.gains = std::move(result.gains);
  outcome.phases = std::move(result.phases);
  outcome.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

robot::Robot without_dither(robot::Robot robot) {
  for (robot::Joint& joint : robot.joints) {
    joint.dither_percent = 0.0;
  }
  return robot;
}

Result<report::Tracking> tracking_of(const robot::Robot& robot, RunOutcome& run, const std::string& trace_path,
                                     std::uint64_t seed, int loop_delay_ticks) {
  if (run.rows.empty()) {
    auto read = FARRIER_TRY(trace::read_trace(trace_path, robot::joint_names(robot)));
    run.rows = std::move(read);
  }
  return report::track(robot, gait::Schedule(robot.plan, seed), run.rows, loop_delay_ticks);
}

Result<Done> add_swing_design(const robot::Robot& robot, const TrotOptions& o, report::Figures& figures) {
  const auto tracking = FARRIER_TRY(track_beside(without_dither(robot), o, supervisor::Design::kSwing,
                                                 o.out + "/trace_swing_design.csv", "trot, swing design beside"));
  report::add_swing_design_tracking(figures, robot, tracking);
  return Done{};
}

Result<Done> add_dither_cost(const robot::Robot& robot, const TrotOptions& o, report::Figures& figures) {
  const auto with = FARRIER_TRY(track_beside(robot, o, supervisor::Design::kPhases, o.out + "/trace_dithered.csv",
                                             "trot, fixed gains with dither"));
  const auto without = FARRIER_TRY(track_beside(without_dither(robot), o, supervisor::Design::kPhases,
                                                o.out + "/trace_undithered.csv", "trot, fixed gains without dither"));
  std::vector<double> ratios;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    ratios.push_back(with.joints[i].stance.nrmse / without.joints[i].stance.nrmse);
  }
  figures.add("trot.dither_cost_ratio", median(std::move(ratios)));
  return Done{};
}

}  // namespace farrier::cli
