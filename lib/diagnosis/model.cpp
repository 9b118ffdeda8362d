#include "diagnosis/model.hpp"

#include <algorithm>

namespace farrier::diagnosis {

ChannelMask channels_of(plant::Side side) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
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

bool Model::has(plant::EffectId id) const noexcept {
  return std::ranges::any_of(effects, [id](const Effect& effect) { return effect.id == id; });
}

}  // namespace farrier::diagnosis
