#pragma once

#include <optional>
#include <span>

#include "plant/actuator.hpp"
#include "plant/effects/effect_set.hpp"
#include "plant/effects/flexible_part.hpp"
#include "plant/effects/land_leaks.hpp"
#include "plant/effects/stateless_terms.hpp"
#include "plant/effects/supply_line.hpp"

namespace farrier::plant {

/// Puts those `effects` into the parameters of a joint that the parameters can represent: valve_dynamics replaces the
/// spool, load_friction the friction of the load, flexible_load the part of its mass that hangs on the rest.
ActuatorParams with_effects(const ActuatorParams& actuator, std::span<const ActiveEffect> effects) noexcept;
LoadParams with_effects(const LoadParams& load, const ActuatorParams& actuator,
                        std::span<const ActiveEffect> effects) noexcept;

/// Least friction in motion of an effect of friction, N or Nm, wherever the joint is.
double least_coulomb(const ActiveEffect& friction) noexcept;

/// Least way, m or rad, over which the contact of an effect of friction may bend: less slides too fast for the shortest
/// substep at the joint's full speed.
double least_presliding(const ActuatorParams& actuator, const ActiveEffect& friction) noexcept;

/// Refuses numbers that are not finite, that lie on the wrong side of 0, and an effect that is there twice.
Result<Done> validate(std::span<const ActiveEffect> effects);

/// Every effect of a joint: on the way from the command to the valve's opening, then from the valve to the chambers,
/// then on the load.
class Effects
    : public EffectSet<Spool, SupplyLine, Lines, Friction, WavyFriction, SealFriction, FlexiblePart, StatelessTerms> {
 public:
  /// Takes the effects in the parameters and, of `effects`, those that are not in them; `tolerance` of a substep.
  Effects(const ActuatorParams& actuator, const LoadParams& load, std::span<const ActiveEffect> effects,
          double tolerance) noexcept;

  /// Sets another load from now on; returns the states that follow.
  X set_load(const LoadParams& load, const X& x) noexcept;

  const Lines& lines() const noexcept { return get<Lines>(); }
};

/// Those effects under which the valve's opening is constant within a tick and the load has none: few states, and code
/// as short as the equations allow. HyQ's joints have no others.
using LeanEffects = EffectSet<SupplyLine, SealFriction, LandLeaks>;

/// Lean effects while the piston slides.
using SlidingEffects = EffectSet<SupplyLine, SlidingSeal, LandLeaks>;

/// The effects as lean ones; none where there are others.
std::optional<LeanEffects> lean(const Effects& effects) noexcept;

}  // namespace farrier::plant
