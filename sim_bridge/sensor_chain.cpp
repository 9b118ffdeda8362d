#include "sim_bridge/sensor_chain.hpp"

#include <cmath>
#include <optional>
#include <string>

namespace farrier::sim_bridge {
namespace {

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
  plant::ForceMoment<double> cell{truth.force};
  terms_.on_force(cell);
  return {truth.position, terms_.on_velocity(truth.velocity), cell.force};
}

Result<SensorChain> SensorChain::create(const robot::Joint& joint, double period_s, std::uint64_t seed) {
  const robot::Sensors& s = joint.sensors;
  if (s.oversampling < 1 || !(period_s > 0.0)) {
    return Error{"sensors: oversampling must be at least 1 and the period above 0"};
  }
  const auto anti_alias = control::design_low_pass(s.anti_alias, s.oversampling / period_s);
  const auto position = control::design_low_pass(s.position, 1.0 / period_s);
  const auto velocity = control::design_low_pass(s.velocity, 1.0 / period_s);
  const auto force = control::design_low_pass(s.force, 1.0 / period_s);
  if (!anti_alias || !position || !velocity || !force) {
    return Error{"sensors: a filter's cut-off must be 0 or within 0.45 of its sampling rate, its order 1 or 2 and its "
                 "damping positive"};
  }
  const auto channel = [&](double noise, const char* name, const control::FilterCoefficients& filter, double step) {
    return SensorChannel({noise, NoiseStream(seed, joint.name, name), *anti_alias, filter, step});
  };
  return SensorChain({channel(joint.noise.position, "position", *position, s.position_step),
                      channel(joint.noise.velocity, "velocity", *velocity, 0.0),
                      channel(joint.noise.force, "force", *force, 0.0)},
                     SensorEffects(joint, period_s / s.oversampling), s.oversampling);
}

void SensorChain::begin(const Measured& truth) noexcept {
  const Measured read = effects_.read(truth);
  channels_[0].settle(read.position);
  channels_[1].settle(read.velocity);
  channels_[2].settle(read.force);
  for (int i = 0; i < conversions_; ++i) {
    convert(truth, 0, i);
  }
}

void SensorChain::convert(const Measured& truth, Tick tick, int index) noexcept {
  const Tick number = tick * conversions_ + index;
  const Measured read = effects_.read(truth);
  channels_[0].convert(read.position, number, index);
  channels_[1].convert(read.velocity, number, index);
  channels_[2].convert(read.force, number, index);
  if (index == conversions_ - 1) {
    sample_ = {channels_[0].sample(conversions_), channels_[1].sample(conversions_), channels_[2].sample(conversions_)};
  }
}

}  // namespace farrier::sim_bridge
