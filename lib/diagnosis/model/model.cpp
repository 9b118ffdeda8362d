#include "diagnosis/model/model.hpp"

#include <algorithm>
#include <cstdlib>

namespace farrier::diagnosis {

ChannelMask channels_of(plant::Side side) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
    case plant::Side::kDrive:
      return {true, false, false};
    case plant::Side::kLoad:
      return {false, true, false};
    case plant::Side::kForceSensor:
      return {true, true, false};
    case plant::Side::kVelocitySensor:
      return {false, false, true};
  }
  return {};
}

bool meet(const ChannelMask& a, const ChannelMask& b) noexcept {
  return (a[0] && b[0]) || (a[1] && b[1]) || (a[2] && b[2]);
}

ChannelMask both_of(const ChannelMask& a, const ChannelMask& b) noexcept {
  return {a[0] && b[0], a[1] && b[1], a[2] && b[2]};
}

ChannelMask either_of(ChannelMask a, const ChannelMask& b) noexcept {
  for (std::size_t c = 0; c < kChannels; ++c) {
    a[c] = a[c] || b[c];
  }
  return a;
}

std::vector<std::vector<double>> starts_of(const plant::EffectInfo& info) {
  const bool alike = info.parameters[0].starts[0] == info.parameters[0].starts[1];
  std::vector<std::vector<double>> starts(alike ? 1 : 2);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    for (const plant::Parameter& parameter : info.parameters) {
      starts[i].push_back(parameter.starts[i]);
    }
  }
  return starts;
}

bool Model::has(plant::EffectId id) const noexcept {
  return std::ranges::any_of(effects, [id](const Effect& effect) { return effect.id == id; });
}

double& number_at(Model& model, std::size_t place) {
  if (place < kNominals) {
    return model.factors[place];
  }
  place -= kNominals;
  for (Model::Effect& effect : model.effects) {
    if (place < effect.fitted.size()) {
      return effect.fitted[place];
    }
    place -= effect.fitted.size();
  }
  std::abort();
}

EffectNumbers<double> effect_numbers(const Model& model) {
  EffectNumbers<double> effects;
  for (const Model::Effect& effect : model.effects) {
    effects.emplace_back(effect.id, effect.fitted);
  }
  return effects;
}

}  // namespace farrier::diagnosis
