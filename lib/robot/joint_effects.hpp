#pragma once

#include <span>

#include "config/problem.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Gives a joint, otherwise derived, the effects of the sections of its `kind` (of joints) and of its own name, which
/// wins: Joint::effects and, for those that change the load, swing_load and stance_load (plant::loads_with_effects).
/// Parameters that the section leaves out get their defaults,
/// in the section too. Returns the problems: no effect, a parameter that is missing, for the other kind of actuator or
/// out of this joint's range, or an impossible load. The joint must then not be used.
config::Problems add_effects(config::Named<JointEffectsSection>& sections, const std::string& kind, Joint& joint);

/// Returns the joint with these effects beside its own; an effect that it already has gets the new numbers. Refuses an
/// impossible load. The `effects` must be in the ranges of this joint.
Result<Joint> with_effects(const Joint& joint, std::span<const plant::ActiveEffect> effects);

}  // namespace farrier::robot
