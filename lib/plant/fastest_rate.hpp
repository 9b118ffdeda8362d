#pragma once

#include "plant/effects/effects.hpp"

namespace farrier::plant {

/// The actuator with chambers reduced by the volume of their lines behind the valve.
ActuatorParams without_lines(ActuatorParams actuator) noexcept;

/// Upper estimate of the fastest rate of a joint's model with its effects, 1/s.
double fastest_rate(const ActuatorParams& actuator, const LoadParams& load, const Effects& effects) noexcept;

/// True if a machine can have this load: it passes validate(), and is not massless together with the piston. For run
/// time, without a sentence.
bool is_physical(const LoadParams& load, double piston_mass) noexcept;

}  // namespace farrier::plant
