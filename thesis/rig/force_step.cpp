#include "thesis/rig/force_step.hpp"

#include <algorithm>
#include <cmath>

#include "control/law/force_controller.hpp"
#include "plant/hydraulic_joint.hpp"
#include "robot/joint_model.hpp"
#include "sim_bridge/sensor_chain.hpp"

namespace farrier::thesis {
namespace {

double reference_at(const ForceStep& step, double time_s) {
  const double since_s = time_s - step.begin_s;
  if (since_s < 0.0) {
    return step.from_N;
  }
  const double share = step.rise_s > 0.0 ? std::min(1.0, since_s / step.rise_s) : 1.0;
  return step.from_N + share * (step.to_N - step.from_N);
}

/// Plant, sensors and controller of the joint at rest under the first reference.
struct Bench {
  robot::Joint joint;
  plant::HydraulicJoint plant;
  sim_bridge::SensorChain sensors;
  control::ForceController controller;
  double home;
  double period_s;

  static Result<Bench> assemble(const robot::Robot& rig, const ForceStep& step) {
    const robot::Joint& joint = rig.joints[0];
    const plant::LoadParams& load = step.heavy ? joint.stance_load : joint.swing_load;
    const double home = joint.linkage.position(joint.home_angle_rad);
    // The springs give the force where the joint stands: at rest, C (x - x_eq) = F.
    const double stand = load.stiffness > 0.0 ? load.equilibrium_position + step.from_N / load.stiffness : home;
    if (!(stand > 0.0 && stand < joint.actuator.stroke)) {
      return Error{joint.name + ": its springs do not give " + config::number_text(step.from_N) +
                   " N within the stroke: give a smaller first force"};
    }
    auto plant = plant::HydraulicJoint::create(joint.actuator, load,
                                               plant::equilibrium(joint.actuator, load, stand, 0.0),
                                               plant::HydraulicJoint::kDefaultTolerance, joint.effects);
    if (!plant) {
      return Error{joint.name + ": " + plant.error().message};
    }
    auto sensors = sim_bridge::SensorChain::create(joint, rig.period_s, step.seed);
    if (!sensors) {
      return Error{joint.name + ": " + sensors.error().message};
    }
    const auto gains = control::design(robot::model_of(joint, load, rig.period_s), joint.design, joint.normalisation,
                                       step.form, 0, rig.period_s);
    if (!gains) {
      return Error{joint.name + ": no gains for this load: " + control::to_string(gains.error())};
    }
    Bench bench{joint, std::move(plant).value(), std::move(sensors).value(), {}, home, rig.period_s};
    bench.sensors.begin(bench.truth());
    bench.controller.set_gains(gains.value(), bench.measured(), step.from_N);
    return bench;
  }

  sim_bridge::Measured truth() const noexcept {
    return {plant.state().position, plant.state().velocity, plant.load_cell_force()};
  }
  control::Measurement measured() const noexcept {
    const sim_bridge::Measured& m = sensors.sample();
    return {m.position - home, m.velocity, m.force};
  }
  ForceStepSample sample(double time_s, double reference_N, const control::ForceController::Output& out) const {
    const double alpha = plant.actuator().area_b / plant.actuator().area_a;
    const plant::State& s = plant.state();
    const plant::EffectReadings e = plant.effects();
    return {.time_s = time_s,
            .reference_N = reference_N,
            .force_N = plant.load_cell_force(),
            .position_m = s.position,
            .velocity_m_s = s.velocity,
            .measured_velocity_m_s = sensors.sample().velocity,
            .load_pressure_Pa = s.pressure_a_Pa - alpha * s.pressure_b_Pa,
            .line_load_pressure_Pa = e.line_pressure_a_Pa - alpha * e.line_pressure_b_Pa,
            .valve_current_A = out.valve_current_A,
            .velocity_part_A = out.velocity_part_A,
            .opening_A = e.opening_A,
            .friction_N = e.friction};
  }
};

}  // namespace

Result<std::vector<ForceStepSample>> run_force_step(const robot::Robot& rig, const ForceStep& step) {
  if (rig.joints.size() != 1) {
    return Error{rig.name + ": a force step is for a rig with one joint, such as fc1d"};
  }
  if (!(step.duration_s > step.begin_s && step.begin_s >= 0.0 && step.duration_s <= 10.0 && step.rise_s >= 0.0 &&
        step.samples_per_tick >= 1 && step.samples_per_tick <= 1000)) {
    return Error{"force step: times must be 0 <= begin_s < duration_s <= 10 and rise_s >= 0, with 1 to 1000 samples a "
                 "tick"};
  }
  auto assembled = FARRIER_TRY(Bench::assemble(rig, step));
  Bench bench = std::move(assembled);
  const int conversions = bench.sensors.conversions();
  const int each = (step.samples_per_tick + conversions - 1) / conversions;  // samples between conversions
  const int parts = each * conversions;
  const auto ticks = static_cast<Tick>(std::llround(step.duration_s / bench.period_s));
  std::vector<ForceStepSample> samples;
  samples.reserve(static_cast<std::size_t>(ticks) * static_cast<std::size_t>(parts));
  for (Tick tick = 0; tick < ticks; ++tick) {
    const double start_s = static_cast<double>(tick) * bench.period_s;
    const double reference_N = reference_at(step, start_s);
    const auto out = bench.controller.step(reference_N, bench.measured());
    for (int part = 0; part < parts; ++part) {
      bench.plant.step(out.valve_current_A, 0.0, bench.period_s / parts);
      samples.push_back(bench.sample(start_s + (part + 1) * bench.period_s / parts, reference_N, out));
      if ((part + 1) % each == 0) {
        bench.sensors.convert(bench.truth(), tick + 1, part / each);
      }
    }
  }
  return samples;
}

Oscillation load_pressure_oscillation(std::span<const ForceStepSample> samples, double from_s, double to_s,
                                      double window_s, bool at_chambers) {
  Oscillation found;
  if (samples.size() < 3) {
    return found;
  }
  const double sample_s = samples[1].time_s - samples[0].time_s;
  const auto half = static_cast<std::ptrdiff_t>(std::max(1.0, std::round(0.5 * window_s / sample_s)));
  const auto pressure = [&](std::ptrdiff_t i) {
    const ForceStepSample& s = samples[static_cast<std::size_t>(i)];
    return at_chambers ? s.load_pressure_Pa : s.line_load_pressure_Pa;
  };
  std::vector<std::pair<double, double>> off;  // time, deviation
  double sum = 0.0;
  for (std::ptrdiff_t i = 0; i < std::ssize(samples); ++i) {
    sum += pressure(i);
    if (i > 2 * half) {
      sum -= pressure(i - 2 * half - 1);
    }
    const std::ptrdiff_t middle = i - half;
    if (i < 2 * half || samples[static_cast<std::size_t>(middle)].time_s < from_s ||
        samples[static_cast<std::size_t>(middle)].time_s > to_s) {
      continue;
    }
    off.emplace_back(samples[static_cast<std::size_t>(middle)].time_s,
                     pressure(middle) - sum / static_cast<double>(2 * half + 1));
  }
  const auto larger = [](const auto& a, const auto& b) { return std::abs(a.second) < std::abs(b.second); };
  const auto peak = std::max_element(off.begin(), off.end(), larger);
  if (peak == off.end()) {
    return found;
  }
  found.peak_Pa = std::abs(peak->second);
  const auto loud = [&](const auto& at) { return std::abs(at.second) >= 0.1 * found.peak_Pa; };
  const auto first = std::find_if(off.begin(), off.end(), loud);
  const auto last = std::find_if(off.rbegin(), off.rend(), loud);
  found.begin_s = first->first;
  found.decay_s = last->first - peak->first;
  std::vector<double> crossings;
  for (auto at = first + 1; at != off.end() && at->first <= last->first; ++at) {
    if ((at->second > 0.0) != ((at - 1)->second > 0.0)) {
      crossings.push_back(at->first);
    }
  }
  if (crossings.size() >= 4) {
    found.frequency_Hz =
        0.5 * static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
  }
  return found;
}

}  // namespace farrier::thesis
