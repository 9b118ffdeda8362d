#include "trials/tracking_gain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/noise.hpp"
#include "plant/hydraulic_joint.hpp"
#include "sim_bridge/sensor_chain.hpp"
#include "trials/armed_joint.hpp"

namespace farrier::trials {
namespace {

constexpr std::array kFrequencies_Hz{2.0, 5.0, 10.0};
constexpr double kLevel_s = 0.25;
constexpr double kRise_s = 0.02;
constexpr double kStrokeShare = 0.25;
constexpr double kSpeedShare = 0.5;
constexpr double kForceShare = 0.25;
constexpr double kLongStep_s = 1.0;   ///< in which any spool is where it goes
constexpr double kCentring_Hz = 1.0;  ///< of a load that has no spring
constexpr double kCentringDamping = 0.7;

/// Spring and damper that lead a load home, by the joint's command.
struct Centring {
  double stiffness = 0.0, damping = 0.0;  ///< actuator coordinates
};

Centring centring_of(const plant::LoadParams& load, const plant::ActuatorParams& actuator) {
  if (load.stiffness > 0.0) {
    return {};
  }
  const double mass = load.mass + actuator.piston_mass;
  const double rate = 2.0 * std::numbers::pi * kCentring_Hz;
  return {(mass * rate + load.damping) * rate, std::max(0.0, 2.0 * kCentringDamping * mass * rate - load.damping)};
}

/// Opening of the valve either way at its largest current, over that without effects.
double full_opening(const robot::Joint& joint) {
  plant::TermSet<double> terms;
  const plant::Scales scales(joint.actuator, joint.swing_load);
  for (const plant::ActiveEffect& effect : joint.effects) {
    add_to(terms, effect, scales, kLongStep_s);
  }
  double least = 1.0;
  for (const double sign : {-1.0, 1.0}) {
    plant::ValveMoment<double> valve{sign * joint.actuator.valve_current_max_A, 1.0};
    terms.on_valve(valve);  // a spool gets half-way in the mean of its first step
    terms.on_valve(valve = {sign * joint.actuator.valve_current_max_A, 1.0});
    least = std::min(least, std::abs(valve.opening_A) * valve.flow_factor / joint.actuator.valve_current_max_A);
  }
  return least;
}

/// Force that is asked for by time, N or Nm.
class ReferenceForce {
 public:
  ReferenceForce(const robot::Joint& joint, std::uint64_t seed) : stream_(seed, joint.name, "tracking reference") {
    const plant::LoadParams& load = joint.swing_load;
    const Centring centring = centring_of(load, joint.actuator);
    double travel = 1.0 / (load.stiffness + centring.stiffness);  // of the level
    double speed = 0.0;
    for (const double frequency_Hz : kFrequencies_Hz) {
      // x / F = 1 / (k + d s + m s^2)
      const double rate = 2.0 * std::numbers::pi * frequency_Hz;
      const double gain = 1.0 / std::hypot(load.stiffness + centring.stiffness - load.mass * rate * rate,
                                           (load.damping + centring.damping) * rate);
      travel += gain;
      speed += gain * rate;
    }
    const double forces = static_cast<double>(kFrequencies_Hz.size()) + 1.0;
    size_ = std::min({kStrokeShare * joint.actuator.stroke / travel,
                      kSpeedShare * full_opening(joint) * plant::velocity_scale(joint.actuator) / speed,
                      kForceShare * std::min(joint.push_limit, joint.pull_limit) / forces});
  }

  double at(double time_s) const noexcept {
    double force = level(time_s);
    for (std::size_t i = 0; i < kFrequencies_Hz.size(); ++i) {
      force +=
          std::sin(2.0 * std::numbers::pi * (kFrequencies_Hz[i] * time_s + stream_.uniform(-1 - static_cast<Tick>(i))));
    }
    return size_ * force;
  }

 private:
  double level(double time_s) const noexcept {
    const auto number = static_cast<Tick>(time_s / kLevel_s);
    const double share = std::min(1.0, (time_s - static_cast<double>(number) * kLevel_s) / kRise_s);
    const auto drawn = [&](Tick n) { return n < 0 ? 0.0 : 2.0 * stream_.uniform(n) - 1.0; };
    return drawn(number - 1) + share * (drawn(number) - drawn(number - 1));
  }

  NoiseStream stream_;
  double size_ = 0.0;
};

/// Root of the mean square error over the reference's standard deviation.
class Judge {
 public:
  void take(double reference, double force) noexcept {
    const double error = reference - force;
    errors_ += error * error;
    sum_ += reference;
    squares_ += reference * reference;
    ++count_;
  }
  double nrmse() const noexcept {
    const double mean = sum_ / count_;
    return std::sqrt(errors_ / (squares_ - count_ * mean * mean));
  }

 private:
  double errors_ = 0.0, sum_ = 0.0, squares_ = 0.0, count_ = 0.0;
};

}  // namespace

Result<double> tracking_nrmse(const robot::Joint& world, const robot::Joint& believed, const ForceTracking& run) {
  const double home = world.linkage.position(world.home_angle_rad);
  const plant::LoadParams& load = world.swing_load;
  const double stand = load.stiffness > 0.0 ? load.equilibrium_position : home;
  auto created =
      plant::HydraulicJoint::create(world.actuator, load, plant::equilibrium(world.actuator, load, stand, 0.0),
                                    plant::HydraulicJoint::kDefaultTolerance, world.effects);
  if (!created) {
    return Error{world.name + ": " + created.error().message};
  }
  plant::HydraulicJoint plant = std::move(created).value();
  auto chain = sim_bridge::SensorChain::create(world, run.period_s, run.seed);
  if (!chain) {
    return Error{world.name + ": " + chain.error().message};
  }
  sim_bridge::SensorChain sensors = std::move(chain).value();
  const auto truth = [&plant] {
    return sim_bridge::Measured{plant.state().position, plant.state().velocity, plant.load_cell_force()};
  };
  sensors.begin(truth());

  robot::Joint quiet = believed;
  quiet.dither_percent = 0.0;
  joint_node::JointNode node = FARRIER_TRY(armed_joint(quiet, quiet, run.period_s, 0));
  const ReferenceForce reference(world, run.seed);
  const Centring centring = centring_of(load, world.actuator);
  const double lever = world.linkage.lever(world.home_angle_rad);
  const auto ticks = static_cast<Tick>(std::llround((run.settle_s + run.duration_s) / run.period_s));
  const auto judged = static_cast<Tick>(std::llround(run.settle_s / run.period_s));
  const int conversions = sensors.conversions();
  Judge judge;
  for (Tick tick = 0; tick < ticks; ++tick) {
    const sim_bridge::Measured& read = sensors.sample();
    const double q = world.linkage.angle(read.position);
    joint_node::JointNode::Inputs in;
    in.tick = in.sensors.tick = in.command.tick = tick;
    in.sensors.position_m_or_rad = read.position;
    in.sensors.velocity_m_s_or_rad_s = read.velocity;
    in.sensors.force_N_or_Nm = read.force;
    in.command.position_rad = world.home_angle_rad;
    in.command.stiffness_Nm_rad = centring.stiffness * lever * lever;
    in.command.damping_Nms_rad = centring.damping * lever * lever;
    in.command.torque_ff_Nm = world.linkage.torque(q, reference.at(static_cast<double>(tick) * run.period_s));
    const joint_node::JointNode::Outputs out = node.step(in);
    if (tick >= judged) {
      judge.take(out.valve.force_reference_N_or_Nm, plant.load_cell_force());
    }
    for (int i = 0; i < conversions; ++i) {
      plant.step(out.valve.valve_current_A, 0.0, run.period_s / conversions);
      sensors.convert(truth(), tick + 1, i);
    }
  }
  return judge.nrmse();
}

Result<TrackingGain> tracking_gain(const robot::Joint& world, const robot::Joint& nominal, const robot::Joint& known,
                                   const ForceTracking& run) {
  const double with_nominal = FARRIER_TRY(tracking_nrmse(world, nominal, run));
  const double with_known = FARRIER_TRY(tracking_nrmse(world, known, run));
  return TrackingGain{with_nominal, with_known};
}

}  // namespace farrier::trials
