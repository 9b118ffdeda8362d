#pragma once

#include <span>

#include "config/problem.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Gives a joint, otherwise derived, the effects of its section: Joint::effects and, for those that are other loads,
/// swing_load and stance_load (plant::loads_with_effects). Parameters that the section leaves out get their defaults,
/// in the section too. Returns what is wrong: no effect, a parameter that is missing, for the other kind of actuator or
/// out of this joint's range, a load that none can have; the joint is then not to be used.
config::Problems add_effects(JointEffectsSection& section, Joint& joint);

/// The joint with these effects beside its own; one that it has already gets the new numbers. Refuses a load that none
/// can have. `effects` are in the ranges of this joint.
Result<Joint> with_effects(const Joint& joint, std::span<const plant::ActiveEffect> effects);

}  // namespace farrier::robot
