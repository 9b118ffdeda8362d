#pragma once

#include <span>

#include "plant/terms/active_effect.hpp"

namespace farrier::plant {

/// A joint's load in swing and in stance.
struct Loads {
  LoadParams swing, stance;
};

/// True if an effect changes a number of the nominal load (its mass, damping, stiffness). It is then in the LoadParams
/// that a joint gets, and HydraulicJoint does nothing for it.
constexpr bool is_in_load(EffectId id) noexcept {
  return effect_info(id).side == Side::kLoad && effect_info(id).nominal;
}

/// The loads of a joint that has these effects. The swing load gets their values. The stance load changes by the same
/// differences of mass, damping and force of the spring, which may leave it with numbers that validate() refuses. The
/// `scales` are those of the joint with its nominal swing load.
Loads loads_with_effects(const Loads& nominal, const Scales& scales, std::span<const ActiveEffect> effects);
inline Loads loads_with_effects(const Loads& nominal, const ActuatorParams& actuator,
                                std::span<const ActiveEffect> effects) {
  return loads_with_effects(nominal, Scales(actuator, nominal.swing), effects);
}

}  // namespace farrier::plant
