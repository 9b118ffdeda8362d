#include "bench/bench_plant_joints.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/noise.hpp"
#include "plant/equations.hpp"
#include "plant/runge_kutta.hpp"

namespace farrier::bench {
namespace {

using plant::ActuatorParams;
using plant::HeldInput;
using plant::IntegrationState;
using plant::JointEquations;
using plant::LoadParams;
using plant::State;

constexpr int kTicksPerPhase = 250;
constexpr std::uint64_t kBenchJointsSeed = 2014;

ActuatorParams cylinder() {
  ActuatorParams p;
  p.area_a = 2.0106e-4;
  p.area_b = 1.2252e-4;
  p.stroke = 0.08;
  p.line_volume_m3 = 8.17e-6;
  p.bulk_modulus_Pa = 1.8181e9;
  p.valve_gain = 6.12e-6;
  p.valve_current_max_A = 0.01;
  p.supply_pressure_Pa = 160e5;
  p.return_pressure_Pa = 1e5;
  p.piston_mass = 0.3141;
  p.piston_damping = 700.0;
  p.stop_stiffness = 1e8;
  p.stop_damping = 1e4;
  return p;
}

ActuatorParams rotary_motor() {
  ActuatorParams p = cylinder();
  p.area_a = p.area_b = 6.87e-6;
  p.stroke = 12.0e-6 / 6.87e-6;
  p.piston_mass = 1e-3;
  p.piston_damping = 1.0;
  p.stop_stiffness = 1e5;
  p.stop_damping = 30.0;
  return p;
}

IntegrationState to_integration(const State& s) { return {s.position, s.velocity, s.pressure_a_Pa, s.pressure_b_Pa}; }

IntegrationState classical_step(const JointEquations& f, const HeldInput& in, const IntegrationState& s, double h) {
  const auto k1 = f.derivative(s, in);
  const auto k2 = f.derivative(plant::add_scaled(s, 0.5 * h, k1), in);
  const auto k3 = f.derivative(plant::add_scaled(s, 0.5 * h, k2), in);
  const auto k4 = f.derivative(plant::add_scaled(s, h, k3), in);
  const auto with_ends = plant::add_scaled(plant::add_scaled(s, h / 6.0, k1), h / 6.0, k4);
  return plant::add_scaled(plant::add_scaled(with_ends, h / 3.0, k2), h / 3.0, k3);
}

/// Draws the valve signal (slow and white noise, centred by the reference's own position) and keeps the reference.
void run_reference(BenchJoint& joint, int number, int ticks) {
  constexpr int kSubsteps = 400;
  const NoiseStream slow(kBenchJointsSeed, std::to_string(number), "slow");
  const NoiseStream white(kBenchJointsSeed, std::to_string(number), "white");
  JointEquations equations(joint.actuator, joint.load_at(0));
  IntegrationState s = to_integration(joint.start);
  double drift = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    equations.set_load(joint.load_at(tick));
    drift += 0.1 * (slow.normal(tick) - drift);
    const double off_centre = s.position / joint.actuator.stroke - 0.5;
    const double opening = std::clamp(0.5 * drift + 0.03 * white.normal(tick) - 2.0 * off_centre, -1.0, 1.0);
    joint.current_A.push_back(opening * joint.actuator.valve_current_max_A);
    const HeldInput input = equations.hold(joint.current_A.back(), 0.0);
    for (int i = 0; i < kSubsteps; ++i) {
      s = classical_step(equations, input, s, kBenchPeriod_s / kSubsteps);
    }
    joint.reference.push_back(
        {s.position, s.velocity, std::max(0.0, s.compression_a_Pa), std::max(0.0, s.compression_b_Pa)});
  }
}

}  // namespace

const LoadParams& BenchJoint::load_at(int tick) const {
  return ((tick / kTicksPerPhase) % 2 == 0) == stance_first ? stance : swing;
}

bool BenchJoint::load_changes_at(int tick) const { return tick % kTicksPerPhase == 0; }

std::vector<BenchJoint> make_bench_joints(int ticks) {
  std::vector<BenchJoint> joints;
  for (int number = 0; number < kBenchJoints; ++number) {
    const bool rotary = number % 3 == 0;
    BenchJoint joint{rotary ? rotary_motor() : cylinder(), {}, {}, (number / 3) % 3 == 0, {}, {}, {}};
    joint.stance = rotary ? LoadParams{5.0, 0.5, 0.0, 0.0} : LoadParams{50.0, 500.0, 0.0, 0.0};
    joint.swing = rotary ? LoadParams{0.3, 0.1, 0.0, 0.0} : LoadParams{2.5, 100.0, 0.0, 0.0};
    joint.start = plant::equilibrium(joint.actuator, joint.load_at(0), 0.5 * joint.actuator.stroke, 0.0);
    run_reference(joint, number, ticks);
    joints.push_back(std::move(joint));
  }
  return joints;
}

void BenchErrorMeter::add(const BenchJoint& joint, int tick, const State& s) {
  const State& r = joint.reference[static_cast<std::size_t>(tick)];
  const double x = (s.position - r.position) / joint.actuator.stroke;
  const double v = (s.velocity - r.velocity) / plant::velocity_scale(joint.actuator);
  const double a = (s.pressure_a_Pa - r.pressure_a_Pa) / joint.actuator.supply_pressure_Pa;
  const double b = (s.pressure_b_Pa - r.pressure_b_Pa) / joint.actuator.supply_pressure_Pa;
  sum_ += x * x + v * v + a * a + b * b;
  count_ += 4;
}

double BenchErrorMeter::rms() const { return std::sqrt(sum_ / count_); }

}  // namespace farrier::bench
