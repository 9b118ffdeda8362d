#pragma once

#include <cstdint>
#include <string>

#include "robot/robot.hpp"

namespace farrier::trials {

/// A hidden effect and its joint.
struct HiddenEffect {
  std::string joint;
  std::string effect;     ///< plant::EffectInfo::name
  std::string parameter;  ///< its first one, by its name on that joint's kind of actuator
  double value;           ///< of that parameter
  std::string unit;       ///< of the value; "1" for a ratio
};

/// The robot as a secret world is: one joint, drawn by `seed`, has one effect more than its file says, of a size to be
/// noticed and to be walked with. The plan, the file and every other joint stay nominal, so everybody but the one who
/// simulates this keeps believing in `nominal`. Effects that the joint has are not drawn. `what` is the answer.
robot::Robot hide_effect(const robot::Robot& nominal, std::uint64_t seed, HiddenEffect& what);

/// The same with joint and effect given; `joint` is its place in Robot::joints, `seed` draws size and sign.
robot::Robot hide_effect(const robot::Robot& nominal, std::size_t joint, plant::EffectId effect, std::uint64_t seed,
                         HiddenEffect& what);

}  // namespace farrier::trials
