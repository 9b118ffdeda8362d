#include "report/trot/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ensure.hpp"
#include "report/figures/text_format.hpp"
#include "report/trot/adaptation_pictures.hpp"
#include "report/trot/joint_poles.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::report {
namespace {

using Rows = std::vector<const trace::TraceRow*>;

/// Rows of each joint in the order of Robot::joints, each in the order of the trace.
std::vector<Rows> rows_by_joint(const robot::Robot& robot, std::span<const trace::TraceRow> rows) {
  std::vector<Rows> by_joint(robot.joints.size());
  for (const trace::TraceRow& row : rows) {
    FARRIER_ENSURE(row.joint < by_joint.size(), "a trace row of a joint the robot does not have");
    by_joint[row.joint].push_back(&row);
  }
  return by_joint;
}

/// Length of the close look.
Tick window_ticks(const ReportInput& input) {
  constexpr int kStrides = 3;
  constexpr double kStanding_s = 2.0;
  return input.robot.plan.gait.pattern == gait::Pattern::kStand ? std::llround(kStanding_s / input.robot.period_s)
                                                                : kStrides * input.schedule.stride_ticks();
}

/// The rows of one joint, and the close look at them: from the first judged tick to `last`, which is not in it.
struct JointRun {
  const ReportInput& input;
  const robot::Joint& joint;
  Rows rows;
  Tick ticks = rows.empty() ? 0 : rows.back()->tick + 1;
  Tick first = first_judged_tick(input.robot, input.schedule, joint.leg);
  Tick last = std::min(ticks, first + window_ticks(input));
  bool rotary = rating_of(input.robot, joint).rotary;
  std::string quantity = rotary ? "torque" : "force", unit = rotary ? "Nm" : "N";

  double seconds(Tick tick) const { return static_cast<double>(tick) * input.robot.period_s; }
  Range window_s() const { return {seconds(first), seconds(last)}; }
};

double error_of(const trace::TraceRow& row) { return row.force_reference_N_or_Nm - row.force_N_or_Nm; }

std::string add_tracking_picture(Drawing& drawing, const JointRun& run) {
  Series stances{.label = "stance (planned)", .style = Style::kSpans, .colour = 1};
  Series reference{.label = "reference"}, force{.label = run.quantity, .colour = 1}, error{.colour = 2};
  bool in_stance = false;
  for (const trace::TraceRow* row : run.rows) {
    if (row->tick < run.first || row->tick >= run.last) {
      continue;
    }
    const double time_s = run.seconds(row->tick);
    reference.add(time_s, row->force_reference_N_or_Nm);
    force.add(time_s, row->force_N_or_Nm);
    error.add(time_s, error_of(*row));
    const bool stance = run.input.schedule.phase(run.joint.leg, row->tick) == gait::Phase::kStance;
    if (stance && !in_stance) {
      stances.add(time_s, time_s);
    }
    if (stance) {
      stances.y.back() = run.seconds(row->tick + 1);
    }
    in_stance = stance;
  }
  if (error.x.empty()) {
    return "";
  }
  Panel above{.y_label = run.quantity + " / " + run.unit,
              .series = {stances, reference, force, {.label = "reference − " + run.quantity, .colour = 2}},
              .x_range = run.window_s()};
  stances.label.clear();
  Panel below{
      .x_label = "time / s", .y_label = "error / " + run.unit, .series = {stances, error}, .x_range = run.window_s()};
  return drawing.add(run.joint.name + "_tracking",
                     {.panels = {above, below}, .key = Key::kAbove, .stacked = true, .height_px = 460.0});
}

/// Adds the lowest and the highest of `values` at one point of a band.
void extend(Series& band, bool begins, double time_s, double value) {
  if (begins) {
    band.add(time_s, value);
    band.high.push_back(value);
  }
  band.y.back() = std::min(band.y.back(), value);
  band.high.back() = std::max(band.high.back(), value);
}

/// Bands from the lowest to the highest value of each of a few hundred intervals of the whole run.
std::string add_overview_picture(Drawing& drawing, const JointRun& run) {
  if (run.rows.empty()) {
    return "";
  }
  constexpr Tick kIntervals = 400;
  const Tick per_interval = std::max<Tick>(1, (run.ticks + kIntervals - 1) / kIntervals);
  const auto [from, to] = run.window_s();
  const Series window{.label = "shown above", .x = {from}, .y = {to}, .style = Style::kSpans, .colour = 2};
  Series reference{.label = "reference", .style = Style::kBand, .colour = 5};
  Series error{.label = "error", .style = Style::kBand, .colour = 2};
  Tick interval = -1;
  for (const trace::TraceRow* row : run.rows) {
    const bool begins = row->tick / per_interval != interval;
    interval = row->tick / per_interval;
    extend(reference, begins, run.seconds(interval * per_interval), row->force_reference_N_or_Nm);
    extend(error, begins, run.seconds(interval * per_interval), error_of(*row));
  }
  return drawing.add(run.joint.name + "_overview", {.panels = {{.x_label = "time / s",
                                                                .y_label = run.quantity + " / " + run.unit,
                                                                .series = {window, reference, error},
                                                                .x_range = Range{0.0, run.seconds(run.ticks)}}},
                                                    .key = Key::kAbove,
                                                    .width_px = 640.0,
                                                    .height_px = 250.0});
}

Series poles_of(const char* design, const control::ClosedLoopPoles& poles, double radius, Style style, int colour) {
  // A loop without delay leaves states unused: poles at zero, up to the root of the rounding of a double one.
  constexpr double kUnused = 1e-6;
  Series series{
      .label = std::string(design) + ": spectral radius " + short_number(radius), .style = style, .colour = colour};
  for (const std::complex<double>& pole : poles) {
    if (std::abs(pole) > kUnused) {
      series.add(pole.real(), pole.imag());
    }
  }
  return series;
}

std::string add_poles_picture(Drawing& drawing, const robot::Joint& joint, const JointPoles& poles) {
  std::vector<Series> series{
      poles_of("stance design, stance load", poles.stance_on_stance, poles.stance_spectral_radius, Style::kDiscs, 1),
      poles_of("stance design, swing load", poles.stance_on_swing, poles.stance_on_swing_spectral_radius,
               Style::kTriangles, 3),
      poles_of("swing design, stance load", poles.swing_on_stance, poles.swing_on_stance_spectral_radius,
               Style::kCrosses, 2)};
  double largest = 1.0;
  for (const Series& one : series) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      largest = std::max(largest, std::hypot(one.x[i], one.y[i]));
    }
  }
  constexpr double kRoom = 1.12;
  return drawing.add(joint.name + "_poles", pole_picture(std::move(series), kRoom * largest));
}

}  // namespace

Result<std::vector<JointPictures>> draw_pictures(const std::string& out_dir, const ReportInput& input) {
  Drawing drawing(out_dir);
  auto by_joint = rows_by_joint(input.robot, input.rows);
  const Tick ticks = input.rows.empty() ? 0 : std::ranges::max(input.rows, {}, &trace::TraceRow::tick).tick + 1;
  const double end_s = static_cast<double>(ticks) * input.robot.period_s;
  std::vector<JointPictures> pictures;
  for (const robot::Joint& joint : input.robot.joints) {
    const JointRun run{input, joint, std::move(by_joint[joint.number])};
    const JointPoles poles = FARRIER_TRY(joint_poles(joint, input.robot.period_s, input.loop_delay_ticks));
    pictures.push_back({.tracking = add_tracking_picture(drawing, run),
                        .overview = add_overview_picture(drawing, run),
                        .poles = add_poles_picture(drawing, joint, poles)});
    if (adapted(input, joint)) {
      pictures.back().gains = FARRIER_TRY(add_gains_picture(drawing, input, joint, end_s));
      pictures.back().estimates = add_estimates_picture(drawing, input, joint);
    }
  }
  FARRIER_TRY(drawing.draw());
  return pictures;
}

}  // namespace farrier::report
