#include "trials/load_cycle.hpp"

#include "trace/force_error.hpp"
#include "trials/grey_box.hpp"
#include "run/run_plan.hpp"
#include "robot/robot_builder.hpp"

namespace farrier::trials {

Result<LoadCycle> make_load_cycle(const robot::Robot& rig, double quarter_s) {
  robot::RobotFile file = rig.file;
  if (rig.joints.size() != 1 || file.loads.size() != 1 || !file.loads[0].second.swing) {
    return Error{rig.name + ": the load cycle of Fig. 7.6 is for a rig with one cylinder and its load, such as fc1d"};
  }
  robot::Load& load = file.loads[0].second;
  load.swing->mass_kg = kLightMass_kg;
  load.stance->mass_kg = kHeavyMass_kg;
  file.gait.pattern = gait::Pattern::kStand;
  auto built = robot::build_robot(std::move(file));
  if (!built) {
    return Error{config::to_string(built.error())};
  }
  LoadCycle cycle{.robot = std::move(built).value(), .loads = {}, .begin = {}, .changes = {}};
  const robot::Joint& joint = cycle.robot.joints[0];
  cycle.loads = {joint.swing_load, joint.stance_load, joint.swing_load, joint.stance_load};
  cycle.loads.back().damping *= kFrictionFactor;
  const Tick lead_in = run::ticks_of(cycle.robot.plan.gait.lead_in_s, cycle.robot);
  const Tick quarter = run::ticks_of(quarter_s, cycle.robot);
  for (std::size_t i = 0; i <= kQuarters; ++i) {
    cycle.begin[i] = lead_in + static_cast<Tick>(i) * quarter;
  }
  for (std::size_t i = 0; i < kQuarters; ++i) {
    cycle.changes.push_back({i == 0 ? 0 : cycle.begin[i], joint.number, cycle.loads[i]});
  }
  return cycle;
}

robot::Robot robot_of(const LoadCycle& cycle, const LoadCycleCase& one) {
  constexpr double kDither_percent = 0.1;
  robot::Robot robot = one.grey_box ? with_grey_box(cycle.robot) : cycle.robot;
  double& percent = robot.joints[0].dither_percent;
  percent = one.dithers ? (percent > 0.0 ? percent : kDither_percent) : 0.0;
  if (one.noiseless) {
    robot.joints[0].noise = {};
  }
  return robot;
}

run::InprocRun run_of(const LoadCycle& cycle, const LoadCycleCase& one, std::uint64_t seed) {
  run::InprocRun run;
  run.ticks = cycle.begin.back();
  run.seed = seed;
  run.design = one.design;
  run.load_changes = cycle.changes;
  if (one.knows_loads) {
    run.known_loads = cycle.changes;
  }
  return run;
}

double quarter_error(const LoadCycle& cycle, std::span<const trace::TraceRow> rows, std::size_t quarter) noexcept {
  const Tick transient = run::ticks_of(trace::kJudgedAfter_s, cycle.robot);
  return trace::relative_error(rows, cycle.begin[quarter] + transient, cycle.begin[quarter + 1]);
}

}  // namespace farrier::trials
