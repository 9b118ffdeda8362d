#pragma once

#include <array>
#include <optional>

#include "config/visitor.hpp"
#include "plant/terms/active_effect.hpp"

namespace farrier::robot {

/// One effect as a file gives it: numbers in the order of its parameters, under their names on a cylinder and, where
/// that is another one, on a motor.
struct EffectSection {
  plant::EffectId id = 0;
  std::array<std::optional<double>, plant::kMostParameters> values, rotary_values;
  config::Place place;
};

/// The effects of one joint, by plant::EffectId.
struct JointEffectsSection {
  std::array<std::optional<EffectSection>, plant::kEffectCount> effects;
  config::Place place;
};

void declare(config::Visitor& v, EffectSection& effect);
void declare(config::Visitor& v, JointEffectsSection& joint);

}  // namespace farrier::robot
