#include "diagnosis/model/joint_simulator.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace farrier::diagnosis {
namespace {

constexpr std::size_t kOilNominals = 8;

/// Places of the nominal factor that an effect replaces, kNominals for none.
std::size_t replaced(plant::EffectId id) noexcept {
  using plant::Scale;
  const plant::EffectInfo& info = plant::effect_info(id);
  if (!info.nominal || info.side != plant::Side::kLoad) {
    return kNominals;
  }
  switch (info.parameters[0].scale) {
    case Scale::kMass:
      return static_cast<std::size_t>(Nominal::kMass);
    case Scale::kDamping:
      return static_cast<std::size_t>(Nominal::kDamping);
    default:
      return static_cast<std::size_t>(Nominal::kStiffness);
  }
}

}  // namespace

JointSimulator::JointSimulator(const JointModel& model, const JointData& data, double force_noise)
    : model_(model), data_(data), force_noise_(force_noise) {
  const auto [low, high] = std::ranges::minmax_element(data.position);
  least_position_ = *low;
  most_position_ = *high;
}

double JointSimulator::least(plant::EffectId effect) const noexcept {
  const bool force = plant::effect_info(effect).parameters[0].scale == plant::Scale::kForce;
  return force ? force_noise_ / scales().of(plant::Scale::kForce) : 0.0;
}

const std::vector<double>& JointSimulator::measured(Channel channel) const noexcept {
  return channel == Channel::kForce    ? data_.force
         : channel == Channel::kMotion ? data_.motion
                                       : data_.measured_velocity;
}

bool JointSimulator::explains(Channel channel, std::size_t sample) const noexcept {
  return channel != Channel::kMotion || knows_load(data_, sample);
}

std::vector<std::vector<double>> JointSimulator::starts(plant::EffectId effect) const {
  const plant::EffectInfo& info = plant::effect_info(effect);
  const plant::Scales& scales = model_.scales();
  if (const std::vector<double>* known = model_.known(effect)) {
    return {*known};
  }
  std::vector<std::vector<double>> all = starts_of(info);
  const double length = scales.of(plant::Scale::kLength);
  if (effect == plant::find_effect("end_stop")) {
    // A stop is seen where the motion turns: just inside the outermost position.
    const double inset = std::min(least_position_, length - most_position_);
    all[0][0] = (inset + 0.02 * (most_position_ - least_position_)) / length;
  }
  for (auto& start : all) {
    for (std::size_t i = 1; i < start.size(); ++i) {
      if (std::string_view(info.parameters[i].name) == "slack_position_m") {
        start[i] = model_.load().stiffness > 0.0 ? model_.load().equilibrium_position / length
                                                 : 0.5 * (least_position_ + most_position_) / length;
      }
    }
  }
  return all;
}

std::vector<FreeNumber> JointSimulator::free_numbers(const Model& model, const ChannelMask& mask,
                                                     double nominal_spread) const {
  std::vector<FreeNumber> free;
  for (std::size_t i = 0; i < kNominals; ++i) {
    const ChannelMask mine = i < kOilNominals ? ChannelMask{true, false, false} : ChannelMask{false, true, false};
    const bool taken = std::ranges::any_of(model.effects, [i](const auto& e) { return replaced(e.id) == i; });
    const bool absent = (i == static_cast<std::size_t>(Nominal::kStiffness) && model_.load().stiffness == 0.0) ||
                        (i == static_cast<std::size_t>(Nominal::kPistonMass) && model_.actuator().piston_mass == 0.0);
    if (meet(mine, mask) && !taken && !absent) {
      free.push_back({i, mine, 1.0 - kNominalBand, 1.0 + kNominalBand, 1.0, nominal_spread});
    }
  }
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    const plant::EffectInfo& info = plant::effect_info(effect.id);
    const ChannelMask mine = channels_of(info.side);
    for (std::size_t i = 0; i < effect.fitted.size(); ++i, ++place) {
      const plant::Parameter& p = info.parameters[i];
      const bool known_slack =
          p.scale == plant::Scale::kLength && info.side == plant::Side::kLoad && i > 0 && model_.load().stiffness > 0.0;
      if (meet(mine, mask) && !known_slack && !p.held) {
        free.push_back({place, mine, p.low, p.high, 0.0, 0.0});
      }
    }
  }
  return free;
}

}  // namespace farrier::diagnosis
