#include "trials/force_bandwidth.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "plant/effects/effects.hpp"
#include "plant/joint.hpp"
#include "plant/load_pressure.hpp"
#include "sim_bridge/sensor_chain.hpp"
#include "trials/armed_joint.hpp"

namespace farrier::trials {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kSettle_s = 0.25;
constexpr double kWindow_s = 0.5;  // whole periods of every even frequency
constexpr double kStep_Hz = 2.0;
constexpr double kRatio = 1.08;  // of neighbouring frequencies, at least
constexpr double kHalfPower = std::numbers::sqrt2 / 2.0;
constexpr double kQuarterTurn_rad = -std::numbers::pi / 2.0;
constexpr double kSwings = 0.5;

/// Force over its reference at one frequency.
struct Response {
  double gain = 1.0;
  double phase_rad = 0.0;  ///< negative: it lags
  double rest = 0.0;       ///< share of the force's mean square that is no part of the sine
};

/// `node` is armed and has not run.
Result<Response> response_at(const HeldJoint& of, joint_node::JointNode node, double amplitude, double frequency_Hz) {
  robot::Joint real = of.real;
  real.noise = {};
  const double position = real.linkage.position(of.angle_rad);
  plant::Joint plant(FARRIER_TRY(plant::HydraulicJoint::create(
      real.actuator, real.swing_load, plant::steady_chambers(real.actuator, {.position = position}),
      plant::HydraulicJoint::kDefaultTolerance, real.effects)));
  sim_bridge::SensorChain sensors = FARRIER_TRY(sim_bridge::SensorChain::create(real, of.period_s, 0));
  sensors.begin(sim_bridge::truth_of(plant));
  std::vector<double> on_the_way_A(static_cast<std::size_t>(of.delay_ticks) + 1, 0.0);
  const auto settled = static_cast<Tick>(std::llround(kSettle_s / of.period_s));
  const Tick end = settled + static_cast<Tick>(std::llround(kWindow_s / of.period_s));
  const double lever = real.linkage.lever(of.angle_rad);
  const int conversions = sensors.conversions();
  std::complex<double> sum = 0.0;
  double total = 0.0, squares = 0.0;
  for (Tick tick = 0; tick < end; ++tick) {
    const double turn_rad = kTwoPi * frequency_Hz * of.period_s * static_cast<double>(tick);
    const double force = plant.readings().load_cell_force;
    if (tick >= settled) {
      sum += force * std::polar(1.0, -turn_rad);
      total += force;
      squares += force * force;
    }
    joint_node::JointNode::Inputs in;
    in.tick = in.sensors.tick = in.command.tick = tick;
    in.sensors.position_m_or_rad = sensors.sample().position;
    in.sensors.velocity_m_s_or_rad_s = sensors.sample().velocity;
    in.sensors.force_N_or_Nm = sensors.sample().force;
    in.command.position_rad = of.angle_rad;
    in.command.torque_ff_Nm = lever * amplitude * std::sin(turn_rad);
    const auto slots = static_cast<Tick>(on_the_way_A.size());
    on_the_way_A[static_cast<std::size_t>(tick % slots)] = node.step(in).valve.valve_current_A;
    const double current_A = on_the_way_A[static_cast<std::size_t>((tick + 1) % slots)];
    for (int i = 0; i < conversions; ++i) {
      plant.follow(current_A, std::nullopt, {.position = position}, of.period_s / conversions);
      sensors.convert(sim_bridge::truth_of(plant), tick + 1, i);
    }
  }
  // sin(turn) has the coefficient -i / 2.
  const double count = static_cast<double>(end - settled);
  const std::complex<double> ratio = sum / count / std::complex<double>(0.0, -0.5 * amplitude);
  const double sine_square = 0.5 * std::norm(ratio * amplitude);
  const double square = squares / count - total * total / (count * count);
  return Response{std::abs(ratio), std::arg(ratio), square > 0.0 ? 1.0 - sine_square / square : 0.0};
}

/// Frequency between two at which a value that falls from `before` to `now` passes `level`.
double crossing_Hz(double low_Hz, double high_Hz, double before, double now, double level) {
  const double share = std::clamp((before - level) / (before - now), 0.0, 1.0);
  return low_Hz * std::pow(high_Hz / low_Hz, share);
}

}  // namespace

Result<ForceBandwidth> force_bandwidth(const HeldJoint& joint, double amplitude) {
  robot::Joint quiet = joint.designed;
  quiet.dither_percent = 0.0;
  const joint_node::JointNode armed = FARRIER_TRY(armed_joint(quiet, joint.known, joint.period_s, joint.delay_ticks));
  ForceBandwidth found;
  Response before;
  double before_Hz = 0.5 * kStep_Hz;
  double frequency_Hz = kStep_Hz;
  while (frequency_Hz <= ForceBandwidth::kHighest_Hz && !(found.gain_Hz && found.phase_Hz)) {
    Response now = FARRIER_TRY(response_at(joint, armed, amplitude, frequency_Hz));
    if (frequency_Hz == kStep_Hz && now.rest > kSwings) {
      found.swings = true;
      return found;
    }
    while (now.phase_rad > before.phase_rad + std::numbers::pi) {
      now.phase_rad -= kTwoPi;
    }
    if (!found.gain_Hz && now.gain < kHalfPower) {
      found.gain_Hz = crossing_Hz(before_Hz, frequency_Hz, before.gain, now.gain, kHalfPower);
    }
    if (!found.phase_Hz && now.phase_rad < kQuarterTurn_rad) {
      found.phase_Hz = crossing_Hz(before_Hz, frequency_Hz, before.phase_rad, now.phase_rad, kQuarterTurn_rad);
    }
    before = now;
    before_Hz = frequency_Hz;
    frequency_Hz = std::max(frequency_Hz + kStep_Hz, kStep_Hz * std::round(kRatio * frequency_Hz / kStep_Hz));
  }
  return found;
}

std::optional<double> spool_Hz(const robot::Joint& real) {
  const plant::SpoolParams spool = plant::with_effects(real.actuator, real.effects).spool;
  return spool.on ? std::optional(spool.natural_frequency_rad_s / kTwoPi) : std::nullopt;
}

double full_flow_Hz(const robot::Joint& real, double angle_rad, double amplitude) {
  const plant::ActuatorParams& actuator = real.actuator;
  const auto rate_of = [&](double sign) {
    return actuator.area_a * actuator.valve_current_max_A *
           plant::load_pressure_coefficients(actuator,
                                             {.position = real.linkage.position(angle_rad), .valve_sign = sign})
               .by_current();
  };
  return std::min(std::abs(rate_of(1.0)), std::abs(rate_of(-1.0))) / (kTwoPi * amplitude);
}

}  // namespace farrier::trials
