#pragma once

#include "plant/effects/effects.hpp"

namespace farrier::plant {

/// The actuator whose chambers lack what their lines hold behind the valve.
ActuatorParams without_lines(ActuatorParams actuator) noexcept;

/// Upper estimate of the fastest rate of a joint's model with its effects, 1/s.
double fastest_rate(const ActuatorParams& actuator, const LoadParams& load, const Effects& effects) noexcept;

/// Whether a machine can have this load: what validate() accepts, and not massless together with the piston. Tells it
/// at run time, without a sentence.
bool is_physical(const LoadParams& load, double piston_mass) noexcept;

}  // namespace farrier::plant
