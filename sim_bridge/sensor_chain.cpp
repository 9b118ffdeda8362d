#include "sim_bridge/sensor_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace farrier::sim_bridge {
namespace {

/// A simulated joint, as channels see it.
struct Truth {
  plant::JointReadings read;
  const plant::HydraulicJoint* hydraulic;  ///< null for an electric joint
};

/// Declaration of one channel.
struct Row {
  const char* name;  ///< addresses the channel's noise
  double Measured::*value;
  double signals::JointSensors::*field;
  double (*truth)(const Truth& joint);
  double (*noise)(const robot::Joint& joint);      ///< standard deviation of a conversion
  control::LowPassParams robot::Sensors::*filter;  ///< at the tick; null: none
  double robot::Sensors::*step;                    ///< resolution; null: none
};

constexpr std::array<Row, kChannels> kRows{{
    {"position", &Measured::position, &signals::JointSensors::position_m_or_rad,
     [](const Truth& joint) { return joint.read.position; },
     [](const robot::Joint& joint) { return joint.noise.position; }, &robot::Sensors::position,
     &robot::Sensors::position_step},
    {"velocity", &Measured::velocity, &signals::JointSensors::velocity_m_s_or_rad_s,
     [](const Truth& joint) { return joint.read.velocity; },
     [](const robot::Joint& joint) { return joint.noise.velocity; }, &robot::Sensors::velocity, nullptr},
    {"force", &Measured::force, &signals::JointSensors::force_N_or_Nm,
     [](const Truth& joint) { return joint.read.load_cell_force; },
     [](const robot::Joint& joint) { return joint.noise.force; }, &robot::Sensors::force, nullptr},
}};
static_assert(std::ranges::all_of(kRows, [](const Row& row) { return row.name != nullptr; }),
              "each member of Measured needs a row");

bool is_filter(const control::FilterCoefficients& c) noexcept {
  return c.b[0] != 1.0 || c.b[1] != 0.0 || c.b[2] != 0.0 || c.a[0] != 0.0 || c.a[1] != 0.0;
}

}  // namespace

SensorChannel::SensorChannel(const Parts& parts) noexcept
    : parts_(parts),
      has_anti_alias_(is_filter(parts.anti_alias)),
      has_filter_(is_filter(parts.filter)),
      anti_alias_(parts.anti_alias),
      filter_(parts.filter) {}

void SensorChannel::settle(double truth) noexcept {
  anti_alias_.settle(truth);
  filter_.settle(truth);
}

void SensorChannel::convert(double truth, Tick number, int index) noexcept {
  double value = truth + parts_.noise * parts_.stream.normal(number);
  if (has_anti_alias_) {
    value = anti_alias_.take(value);
  }
  if (parts_.step > 0.0) {
    value = parts_.step * std::floor(value / parts_.step + 0.5);
  }
  sum_ = index == 0 ? value : sum_ + value;
}

double SensorChannel::sample(int conversions) noexcept {
  const double mean = sum_ / conversions;
  return has_filter_ ? filter_.take(mean) : mean;
}

SensorEffects::SensorEffects(const robot::Joint& joint, double period_s) noexcept {
  if (joint.effects.empty()) {
    return;  // an electric joint has no scales
  }
  const plant::Scales scales(joint.actuator, joint.swing_load);
  for (const plant::ActiveEffect& effect : joint.effects) {
    const plant::Side side = effect.info().side;
    if (side == plant::Side::kForceSensor || side == plant::Side::kVelocitySensor) {
      add_to(terms_, effect, scales, period_s);
      any_ = true;
    }
  }
}

Measured SensorEffects::read(const Measured& truth) noexcept {
  if (!any_) {
    return truth;
  }
  Measured read = truth;
  plant::ForceMoment<double> cell{truth.force};
  terms_.on_force(cell);
  read.velocity = terms_.on_velocity(truth.velocity);
  read.force = cell.force;
  return read;
}

Measured truth_of(const plant::Joint& joint) noexcept {
  const Truth seen{joint.readings(), joint.hydraulic()};
  Measured truth;
  for (const Row& row : kRows) {
    truth.*row.value = row.truth(seen);
  }
  return truth;
}

void put(const Measured& sample, signals::JointSensors& sensors) noexcept {
  for (const Row& row : kRows) {
    sensors.*row.field = sample.*row.value;
  }
}

Result<SensorChain> SensorChain::create(const robot::Joint& joint, double period_s, std::uint64_t seed) {
  const robot::Sensors& s = joint.sensors;
  if (s.oversampling < 1 || !(period_s > 0.0)) {
    return Error{"sensors: oversampling must be at least 1 and the period above 0"};
  }
  const auto anti_alias = control::design_low_pass(s.anti_alias, s.oversampling / period_s);
  std::vector<SensorChannel> channels;
  for (const Row& row : kRows) {
    const auto filter =
        control::design_low_pass(row.filter != nullptr ? s.*row.filter : control::LowPassParams{}, 1.0 / period_s);
    if (!anti_alias || !filter) {
      return Error{
          "sensors: a filter's cut-off must be 0 or within 0.45 of its sampling rate, its order 1 or 2 and its "
          "damping positive"};
    }
    channels.push_back(SensorChannel({row.noise(joint), NoiseStream(seed, joint.name, row.name), *anti_alias, *filter,
                                      row.step != nullptr ? s.*row.step : 0.0}));
  }
  return SensorChain(std::move(channels), SensorEffects(joint, period_s / s.oversampling), s.oversampling);
}

void SensorChain::begin(const Measured& truth) noexcept {
  const Measured read = effects_.read(truth);
  for (std::size_t i = 0; i < kChannels; ++i) {
    channels_[i].settle(read.*kRows[i].value);
  }
  for (int i = 0; i < conversions_; ++i) {
    convert(truth, 0, i);
  }
}

void SensorChain::convert(const Measured& truth, Tick tick, int index) noexcept {
  const Tick number = tick * conversions_ + index;
  const Measured read = effects_.read(truth);
  const bool last = index == conversions_ - 1;
  for (std::size_t i = 0; i < kChannels; ++i) {
    channels_[i].convert(read.*kRows[i].value, number, index);
    if (last) {
      sample_.*kRows[i].value = channels_[i].sample(conversions_);
    }
  }
}

}  // namespace farrier::sim_bridge
