#include "diagnosis/model/joint_simulator.hpp"

#include <algorithm>
#include <string_view>

#include "diagnosis/model/side_runs.hpp"

namespace farrier::diagnosis {

JointSimulator::JointSimulator(const JointSides& model, const JointData& data, double force_noise)
    : model_(model), data_(data), force_noise_(force_noise) {
  for (plant::EffectId id = 0; id < plant::kNameableCount; ++id) {
    starts_.push_back(model.starts(id, data));
  }
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

std::vector<FreeNumber> JointSimulator::free_numbers(const Model& model, const ChannelMask& mask,
                                                     double nominal_spread) const {
  std::vector<FreeNumber> free;
  for (std::size_t i = 0; i < kNominals; ++i) {
    const ChannelMask mine = model_.nominal_channels(i);
    const bool taken = std::ranges::any_of(model.effects, [&](const auto& e) { return model_.replaced(e.id) == i; });
    if (meet(mine, mask) && !taken) {
      free.push_back({i, mine, 1.0 - kNominalBand, 1.0 + kNominalBand, 1.0, nominal_spread});
    }
  }
  std::size_t place = kNominals;
  for (const Model::Effect& effect : model.effects) {
    const plant::EffectInfo& info = plant::effect_info(effect.id);
    const ChannelMask mine = model_.channels(effect.id);
    for (std::size_t i = 0; i < effect.fitted.size(); ++i, ++place) {
      const plant::Parameter& p = info.parameters[i];
      const bool known_slack = model_.load().stiffness > 0.0 && std::string_view(p.name).starts_with("slack_position");
      if (meet(mine, mask) && !known_slack && model_.fits(effect.id, i)) {
        free.push_back({place, mine, p.low, p.high, 0.0, 0.0});
      }
    }
  }
  return free;
}

}  // namespace farrier::diagnosis
