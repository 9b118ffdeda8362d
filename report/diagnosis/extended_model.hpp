#pragma once

#include <span>
#include <string>

#include "core/result.hpp"
#include "plant/terms/active_effect.hpp"
#include "robot/robot.hpp"

namespace farrier::report {

/// The robot file, defaults filled in, with these effects of a joint in its section `effects`; one that the joint has
/// already gets the new numbers. Refuses with the reader's problems what does not load again to a joint with these
/// effects.
Result<std::string> extended_model(const robot::Robot& robot, const robot::Joint& joint,
                                   std::span<const plant::ActiveEffect> found);

}  // namespace farrier::report
