#include "thesis/rig/rig_run.hpp"
#include "thesis/study/mean.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/law/feedback_linearisation.hpp"
#include "control/law/force_controller.hpp"
#include "plant/hydraulic_joint.hpp"
#include "robot/joint_model.hpp"
#include "sim_bridge/sensor_chain.hpp"

namespace farrier::thesis {
namespace {

/// The joint behind its sensors.
struct Rig {
  plant::HydraulicJoint plant;
  sim_bridge::SensorChain sensors;
  double middle_m;
  double period_s;
  Tick tick = 0;

  static Result<Rig> assemble(const robot::Robot& robot, const plant::LoadParams& load, double position_m,
                              std::uint64_t seed) {
    const robot::Joint& joint = robot.joints[0];
    const double middle = joint.linkage.position(joint.home_angle_rad);
    auto plant = plant::HydraulicJoint::create(joint.actuator, load,
                                               plant::equilibrium(joint.actuator, load, middle + position_m, 0.0),
                                               plant::HydraulicJoint::kDefaultTolerance, joint.effects);
    if (!plant) {
      return Error{joint.name + ": " + plant.error().message};
    }
    auto sensors = sim_bridge::SensorChain::create(joint, robot.period_s, seed);
    if (!sensors) {
      return Error{joint.name + ": " + sensors.error().message};
    }
    Rig rig{std::move(plant).value(), std::move(sensors).value(), middle, robot.period_s};
    rig.sensors.begin(rig.truth());
    return rig;
  }

  sim_bridge::Measured truth() const noexcept {
    return {plant.state().position, plant.state().velocity, plant.load_cell_force()};
  }
  control::Measurement measured() const noexcept {
    const sim_bridge::Measured& m = sensors.sample();
    return {m.position - middle_m, m.velocity, m.force};
  }
  void advance(double current_A) noexcept {
    ++tick;
    const int conversions = sensors.conversions();
    for (int i = 0; i < conversions; ++i) {
      plant.step(current_A, 0.0, period_s / conversions);
      sensors.convert(truth(), tick, i);
    }
  }
  double time_s() const noexcept { return static_cast<double>(tick) * period_s; }
};

void note(RigTrace& trace, const Rig& rig, double reference_N, const control::ForceController::Output& out) {
  const plant::State& s = rig.plant.state();
  const control::Measurement m = rig.measured();
  const double alpha = rig.plant.actuator().area_b / rig.plant.actuator().area_a;
  trace.time_s.push_back(rig.time_s());
  trace.reference_N.push_back(reference_N);
  trace.force_N.push_back(rig.plant.load_cell_force());
  trace.position_m.push_back(s.position - rig.middle_m);
  trace.velocity_m_s.push_back(s.velocity);
  trace.pressure_a_Pa.push_back(s.pressure_a_Pa);
  trace.pressure_b_Pa.push_back(s.pressure_b_Pa);
  trace.load_pressure_Pa.push_back(s.pressure_a_Pa - alpha * s.pressure_b_Pa);
  trace.measured_position_m.push_back(m.position);
  trace.measured_velocity_m_s.push_back(m.velocity);
  trace.measured_force_N.push_back(m.force);
  trace.current_A.push_back(out.valve_current_A);
  trace.position_part_A.push_back(out.position_part_A);
  trace.velocity_part_A.push_back(out.velocity_part_A);
  trace.force_part_A.push_back(out.force_part_A);
  trace.integral_part_A.push_back(out.integral_part_A);
  trace.feed_forward_part_A.push_back(out.feed_forward_part_A);
}

struct Range {
  std::size_t begin, end;
};

Range range_of(const RigTrace& run, double from_s, double to_s) {
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(run.time_s.begin(), run.time_s.end(), t - 0.5 * run.period_s) -
                                    run.time_s.begin());
  };
  return {at(from_s), at(to_s)};
}

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Result<robot::Robot> load_rig(const StudyContext& context) { return load(context, "fc1d_real.yaml"); }

Result<RigTrace> track(const robot::Robot& robot, const Tracking& tracking, std::uint64_t seed) {
  const robot::Joint& joint = robot.joints[0];
  plant::LoadParams load = joint.swing_load;
  auto made = FARRIER_TRY(Rig::assemble(robot, load, 0.0, seed));
  Rig rig = std::move(made);
  plant::LoadParams designed_for = load;
  designed_for.mass += tracking.designed_for_kg;
  control::LqrWeights weights = tracking.weights;
  weights.feed_forward_factor = tracking.feed_forward_factor;
  weights.integral_factor = tracking.integral_factor;
  const auto gains = control::design_lqr(robot::model_of(joint, designed_for, robot.period_s), weights,
                                         joint.normalisation, tracking.form, 0);
  if (!gains) {
    return Error{joint.name + ": no gains for this load: " + control::to_string(gains.error())};
  }
  control::ForceController lqr;
  lqr.set_gains(gains.value(), rig.measured(), tracking.reference(0.0));
  control::FeedbackLinearisation fl(joint.actuator, joint.feedback_linearisation, rig.middle_m, robot.period_s);
  RigTrace trace;
  trace.period_s = robot.period_s;
  const auto ticks = static_cast<Tick>(std::llround(tracking.duration_s / robot.period_s));
  std::size_t weight = 0;
  while (rig.tick < ticks) {
    while (weight < tracking.added.size() && rig.time_s() >= tracking.added[weight].at_s) {
      load.mass = joint.swing_load.mass + tracking.added[weight++].total_kg;
      rig.plant.set_load(load);
    }
    const double reference = tracking.reference(rig.time_s());
    control::ForceController::Output out{};
    if (tracking.kind == control::Kind::kFeedbackLinearisation) {
      out.valve_current_A = fl.step(reference, rig.measured()).valve_current_A;
    } else {
      out = lqr.step(reference, rig.measured());
    }
    note(trace, rig, reference, out);
    rig.advance(out.valve_current_A);
  }
  return trace;
}

Result<RigTrace> drive(const robot::Robot& robot, const Driving& driving, std::uint64_t seed) {
  plant::LoadParams load = robot.joints[0].swing_load;
  load.mass += driving.added_kg;
  auto made = FARRIER_TRY(Rig::assemble(robot, load, driving.position_m, seed));
  Rig rig = std::move(made);
  RigTrace trace;
  trace.period_s = robot.period_s;
  const auto ticks = static_cast<Tick>(std::llround(driving.duration_s / robot.period_s));
  while (rig.tick < ticks) {
    control::ForceController::Output out{};
    out.valve_current_A = driving.current_A(rig.time_s());
    note(trace, rig, 0.0, out);
    rig.advance(out.valve_current_A);
  }
  return trace;
}

Signal chirp(double amplitude, double to_Hz, double duration_s) {
  // f(t) = to t / T, so the phase is pi to t^2 / T.
  return [=](double t) { return amplitude * std::sin(std::numbers::pi * to_Hz * t * t / duration_s); };
}

Signal sine(double amplitude, double frequency_Hz) {
  return [=](double t) { return amplitude * std::sin(2.0 * std::numbers::pi * frequency_Hz * t); };
}

double rms(const RigTrace& run, const std::vector<double>& values, double from_s, double to_s) {
  const Range range = range_of(run, from_s, to_s);
  double sum = 0.0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    sum += values[i] * values[i];
  }
  return range.end > range.begin ? std::sqrt(sum / static_cast<double>(range.end - range.begin)) : kNothing;
}

double tracking_error(const RigTrace& run, double from_s, double to_s) {
  std::vector<double> error(run.force_N.size());
  std::ranges::transform(run.reference_N, run.force_N, error.begin(), std::minus<>());
  return rms(run, error, from_s, to_s) / rms(run, run.reference_N, from_s, to_s);
}

double lag_deg(const RigTrace& run, double frequency_Hz, double from_s) {
  const double whole = std::floor((run.time_s.back() + run.period_s - from_s) * frequency_Hz + 1e-9) / frequency_Hz;
  const Range range = range_of(run, from_s, from_s + whole);
  double in_phase = 0.0;
  double quadrature = 0.0;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double angle = 2.0 * std::numbers::pi * frequency_Hz * run.time_s[i];
    in_phase += run.force_N[i] * std::sin(angle);
    quadrature += run.force_N[i] * std::cos(angle);
  }
  return range.end > range.begin ? -std::atan2(quadrature, in_phase) * 180.0 / std::numbers::pi : kNothing;
}

double mean(const RigTrace& run, const std::vector<double>& values, double from_s, double to_s) {
  const Range range = range_of(run, from_s, to_s);
  return mean_over(range.begin, range.end, [&](std::size_t i) { return values[i]; });
}

double standing(const RigTrace& run, double from_s, double to_s) {
  constexpr double kStanding_m_s = 1e-3;
  const Range range = range_of(run, from_s, to_s);
  return mean_over(range.begin, range.end,
                   [&](std::size_t i) { return std::abs(run.velocity_m_s[i]) < kStanding_m_s ? 1.0 : 0.0; });
}

double ripple(const RigTrace& run, const std::vector<double>& values, double window_s, double from_s, double to_s) {
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * window_s / run.period_s)));
  std::vector<double> total(values.size() + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    total[i + 1] = total[i] + values[i];
  }
  std::vector<double> quick(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t begin = i > half ? i - half : 0;
    const std::size_t end = std::min(values.size(), i + half + 1);
    quick[i] = values[i] - (total[end] - total[begin]) / static_cast<double>(end - begin);
  }
  return rms(run, quick, from_s, to_s);
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> result(values);
  std::ranges::for_each(result, [=](double& value) { value *= factor; });
  return result;
}

Panel force_panel(const std::string& title, const RigTrace& run) {
  constexpr double kDrawn = 3.0;  // over the reference
  const auto size = [](double f) { return std::abs(f); };
  const double most_N = kDrawn * std::abs(std::ranges::max(run.reference_N, {}, size));
  const double largest_N = std::abs(std::ranges::max(run.force_N, {}, size));
  std::vector<double> force(run.force_N);
  std::ranges::for_each(force, [=](double& f) { f = std::clamp(f, -most_N, most_N); });
  const std::string cut =
      largest_N > most_N ? number_as("cut at three times the reference; the force goes to %.0f N", largest_N) : "";
  return {.title = title + (title.empty() || cut.empty() ? "" : ": ") + cut,
          .x_label = "time (s)",
          .y_label = "force (N)",
          .series = {{"reference", run.time_s, run.reference_N, Style::kLine, 0},
                     {"force", run.time_s, std::move(force), Style::kLine, 1}}};
}

Panel parts_panel(const RigTrace& run, double current_max_A) {
  const double percent = 100.0 / current_max_A;
  return {.title = "",
          .x_label = "time (s)",
          .y_label = "of the valve opening (%)",
          .series = {{"total", run.time_s, scaled(run.current_A, percent), Style::kLine, 0},
                     {"force", run.time_s, scaled(run.force_part_A, percent), Style::kLine, 1},
                     {"feed-forward", run.time_s, scaled(run.feed_forward_part_A, percent), Style::kLine, 2},
                     {"velocity", run.time_s, scaled(run.velocity_part_A, percent), Style::kLine, 3},
                     {"position", run.time_s, scaled(run.position_part_A, percent), Style::kLine, 4},
                     {"integral", run.time_s, scaled(run.integral_part_A, percent), Style::kLine, 5}}};
}

}  // namespace farrier::thesis
