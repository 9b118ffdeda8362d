#include "thesis/rig/load_cycle_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "trace/force_error.hpp"
#include "robot/joint_model.hpp"

namespace farrier::thesis {

using signals::JointControllerGains;

namespace {

using Change = std::function<void(robot::Robot&)>;

Result<CycleRun> run_changed(const StudyContext& context, const trials::LoadCycleCase& one, double from, double to,
                             const Change& change) {
  const auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  auto cycle = trials::make_load_cycle(rig);
  if (!cycle) {
    return cycle.error();
  }
  CycleRun run{std::move(cycle).value(), {}, {}};
  run::InprocRun settings = trials::run_of(run.cycle, one, context.seed);
  bool stop = false;
  settings.sink = [&](const trace::TraceRow& row) { run.rows.push_back(row); };
  settings.progress = [&](Tick tick) {
    stop = !keep_going(context, from + (to - from) * static_cast<double>(tick) / static_cast<double>(settings.ticks));
    return !stop;
  };
  robot::Robot robot = trials::robot_of(run.cycle, one);
  change(robot);
  const auto ran = run::run_inproc(robot, settings);
  if (!ran) {
    return stop ? stopped() : ran.error();
  }
  for (const JointControllerGains& gains : ran.value().gains) {
    if (gains.phase == signals::Phase::kStance) {
      run.gains.push_back(gains);
    }
  }
  if (run.gains.empty()) {
    return Error{"the load cycle's run issued no gains"};
  }
  std::ranges::stable_sort(run.gains, {}, &JointControllerGains::effective_tick);
  return run;
}

}  // namespace

Result<CycleRun> run_cycle(const StudyContext& context, const trials::LoadCycleCase& one, double from, double to) {
  return run_changed(context, one, from, to, [](robot::Robot&) {});
}

Result<CycleRun> run_cycle_as_printed(const StudyContext& context, double forgetting_factor) {
  return run_changed(context, trials::kAdaptiveNoiselessCase, 0.0, 1.0, [=](robot::Robot& robot) {
    robot::Joint& joint = robot.joints[0];
    joint.dither_percent = 0.0;
    joint.estimator.model_error = 0.0;
    joint.estimator.forgetting_factor = forgetting_factor;
    joint.estimator.bias = false;
    joint.estimator.operating_point_order = 0;
    joint.estimator.full_weight_norm = 1e6;
    joint.design.weights.integral_factor = 6.0;
    robot.update_logic.validity_min = 0.05;
    robot.update_logic.model_uncertainty = 1.0;
  });
}

double quarter_error(const CycleRun& run, std::size_t quarter) {
  return trials::quarter_error(run.cycle, run.rows, quarter - 1);
}

const JointControllerGains& acting_before(const CycleRun& run, Tick tick) {
  const JointControllerGains* acting = &run.gains.front();
  for (const JointControllerGains& gains : run.gains) {
    acting = gains.effective_tick < tick ? &gains : acting;
  }
  return *acting;
}

const JointControllerGains& at_end_of(const CycleRun& run, std::size_t quarter) {
  return acting_before(run, run.cycle.begin[quarter]);
}

control::DiscreteModel truth_of(const CycleRun& run, std::size_t quarter) {
  return robot::model_of(run.cycle.robot.joints[0], run.cycle.loads[quarter - 1], run.cycle.robot.period_s);
}

std::string gains_text(const JointControllerGains& gains) {
  char text[64];
  std::snprintf(text, sizeof text, "K = [%.3g, %.3g, %.3g]", gains.k_position, gains.k_velocity, gains.k_force);
  return text;
}

}  // namespace farrier::thesis
