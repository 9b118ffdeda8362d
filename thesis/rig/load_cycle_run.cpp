#include "thesis/rig/load_cycle_run.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <span>

#include "trace/force_error.hpp"
#include "robot/joint_model.hpp"

namespace farrier::thesis {

using signals::JointControllerGains;

namespace {

using Change = std::function<Result<Done>(robot::Robot&, run::InprocRun&)>;

Result<CycleRun> run_changed(const StudyContext& context, const trials::LoadCycleCase& one, double from, double to,
                             const Change& change) {
  auto rig = FARRIER_TRY(load(context, "fc1d.yaml"));
  rig.file.gait.lead_in_s = 0.0;  // Figs 7.7 and 7.8 begin with the whole reference
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
  FARRIER_TRY(change(robot, settings));
  run.cycle.robot = robot;
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

double highest_frequency_Hz(const CycleRun& run) {
  return std::ranges::max(run.cycle.robot.file.gait.multisine_frequencies_Hz);
}

/// Rows of a quarter without its transient.
std::vector<trace::TraceRow> settled_rows(const CycleRun& run, std::size_t quarter) {
  const Tick from = run.cycle.begin[quarter - 1] + run::ticks_of(trace::kJudgedAfter_s, run.cycle.robot);
  std::vector<trace::TraceRow> rows;
  std::ranges::copy_if(run.rows, std::back_inserter(rows), [&](const trace::TraceRow& row) {
    return row.tick >= from && row.tick < run.cycle.begin[quarter];
  });
  return rows;
}

/// Phase (rad) at the highest of the frequencies, of sines of all of them fitted to `value` of the rows.
template <class Value>
double phase_of(std::span<const trace::TraceRow> rows, const std::vector<double>& frequencies_Hz, double period_s,
                const Value& value) {
  const auto count = static_cast<Eigen::Index>(frequencies_Hz.size());
  Eigen::MatrixXd sines(std::ssize(rows), 2 * count);
  Eigen::VectorXd values(std::ssize(rows));
  for (Eigen::Index i = 0; i < std::ssize(rows); ++i) {
    const trace::TraceRow& row = rows[static_cast<std::size_t>(i)];
    values(i) = value(row);
    for (Eigen::Index f = 0; f < count; ++f) {
      const double angle = 2.0 * std::numbers::pi * frequencies_Hz[static_cast<std::size_t>(f)] *
                           static_cast<double>(row.tick) * period_s;
      sines(i, 2 * f) = std::sin(angle);
      sines(i, 2 * f + 1) = std::cos(angle);
    }
  }
  const Eigen::VectorXd fitted = sines.colPivHouseholderQr().solve(values);
  const auto highest = 2 * std::distance(frequencies_Hz.begin(), std::ranges::max_element(frequencies_Hz));
  return std::atan2(fitted(highest + 1), fitted(highest));
}

}  // namespace

Result<CycleRun> run_cycle(const StudyContext& context, const trials::LoadCycleCase& one, double from, double to) {
  return run_changed(context, one, from, to, [](robot::Robot&, run::InprocRun&) -> Result<Done> { return Done{}; });
}

Result<control::Gains> printed_gains(const robot::Robot& robot, const plant::LoadParams& load) {
  const robot::Joint& joint = robot.joints[0];
  const auto gains =
      control::design(robot::model_of(joint, load, robot.period_s, {.piston = plant::PistonMass::kNeglected}),
                      joint.design, joint.normalisation, joint.form, 0, robot.period_s);
  if (!gains) {
    return Error{std::string("no design on (3.51) for ") + std::to_string(load.mass) +
                 " kg: " + control::to_string(gains.error())};
  }
  return gains.value();
}

Result<CycleRun> run_cycle_as_printed(const StudyContext& context, const PrintedCycle& printed, double from,
                                      double to) {
  trials::LoadCycleCase one = printed.adaptive ? trials::kAdaptiveCase : trials::kFixedCase;
  one.noiseless = true;
  return run_changed(context, one, from, to, [&](robot::Robot& robot, run::InprocRun& settings) -> Result<Done> {
    robot::Joint& joint = robot.joints[0];
    joint.dither_percent = printed.probing_percent;
    joint.name += "_" + std::to_string(context.seed);  // the dither is drawn by name
    joint.estimator.model_error = 0.0;
    joint.estimator.forgetting_factor = printed.forgetting_factor;
    joint.estimator.bias = false;
    joint.estimator.operating_point_order = 0;
    joint.estimator.full_weight_norm = 1e6;
    joint.design.weights.integral_factor = 6.0;
    robot.update_logic.validity_min = 0.05;
    robot.update_logic.model_uncertainty = 1.0;
    robot.update_logic.disk_margin_min = 0.0;
    robot.update_logic.delay_margin_min_s = 0.0;
    const auto light = FARRIER_TRY(printed_gains(robot, joint.swing_load));
    settings.first_gains = {{light, light}};
    return Done{};
  });
}

double quarter_error(const CycleRun& run, std::size_t quarter) {
  return trials::quarter_error(run.cycle, run.rows, quarter - 1);
}

double error_from(const CycleRun& run, Tick tick) {
  return trace::relative_error(run.rows, tick, tick + run::ticks_of(1.0 / highest_frequency_Hz(run), run.cycle.robot));
}

double quarter_lag_deg(const CycleRun& run, std::size_t quarter) {
  const std::vector<trace::TraceRow> rows = settled_rows(run, quarter);
  const auto phase = [&](double trace::TraceRow::*value) {
    return phase_of(rows, run.cycle.robot.file.gait.multisine_frequencies_Hz, run.cycle.robot.period_s,
                    [&](const trace::TraceRow& row) { return row.*value; });
  };
  const double lag = phase(&trace::TraceRow::force_reference_N_or_Nm) - phase(&trace::TraceRow::force_N_or_Nm);
  return std::remainder(lag, 2.0 * std::numbers::pi) * 180.0 / std::numbers::pi;
}

double quarter_overshoot(const CycleRun& run, std::size_t quarter) {
  double reference = 0.0, force = 0.0;
  for (const trace::TraceRow& row : settled_rows(run, quarter)) {
    reference = std::max(reference, std::abs(row.force_reference_N_or_Nm));
    force = std::max(force, std::abs(row.force_N_or_Nm));
  }
  return force / reference - 1.0;
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

Picture force_picture(const CycleRun& run, const std::string& caption) {
  Series reference{"reference", {}, {}, Style::kLine, 1};
  Series force{"force", {}, {}, Style::kLine, 3};
  double highest_N = 0.0;
  double largest_N = 0.0;
  for (const trace::TraceRow& row : run.rows) {
    highest_N = std::max(highest_N, std::abs(row.force_reference_N_or_Nm));
  }
  for (const trace::TraceRow& row : run.rows) {
    const double t = static_cast<double>(row.tick) * run.cycle.robot.period_s;
    reference.x.push_back(t);
    reference.y.push_back(row.force_reference_N_or_Nm);
    force.x.push_back(t);
    largest_N = std::max(largest_N, std::abs(row.force_N_or_Nm));
    force.y.push_back(std::clamp(row.force_N_or_Nm, -2.0 * highest_N, 2.0 * highest_N));
  }
  std::array<Series, 3> gains{{{"position", {}, {}, Style::kLine, 1},
                               {"velocity", {}, {}, Style::kLine, 2},
                               {"force", {}, {}, Style::kLine, 3}}};
  for (Tick tick = 0; tick < run.cycle.begin.back(); tick += 5) {
    const JointControllerGains& acting = acting_before(run, tick + 1);
    const double values[] = {acting.k_position, acting.k_velocity, acting.k_force};
    for (std::size_t i = 0; i < gains.size(); ++i) {
      gains[i].x.push_back(static_cast<double>(tick) * run.cycle.robot.period_s);
      gains[i].y.push_back(values[i]);
    }
  }
  const bool cut = largest_N > 2.0 * highest_N;
  return {caption,
          1,
          {{.title = cut ? number_as("cut at twice the reference; the force goes to %.0f N", largest_N) : "",
            .x_label = "time (s)",
            .y_label = "force (N)",
            .series = {std::move(reference), std::move(force)}},
           {.title = "",
            .x_label = "time (s)",
            .y_label = "gain",
            .series = {std::move(gains[0]), std::move(gains[1]), std::move(gains[2])}}}};
}

std::string gains_text(const JointControllerGains& gains) {
  char text[64];
  std::snprintf(text, sizeof text, "K = [%.3g, %.3g, %.3g]", gains.k_position, gains.k_velocity, gains.k_force);
  return text;
}

}  // namespace farrier::thesis
