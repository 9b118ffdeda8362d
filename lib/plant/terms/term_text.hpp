#pragma once

#include <array>
#include <cstddef>

#include "plant/terms/term.hpp"

namespace farrier::plant {

struct SideText {
  const char* name;      ///< for tables
  const char* sentence;  ///< for robot files
};
inline constexpr std::array kSideTexts{
    SideText{"valve and oil", "Effect between the current and the load cell."},
    SideText{"load", "Effect behind the load cell."},
    SideText{"force sensor", "Effect of the load cell."},
    SideText{"velocity sensor", "Effect of the velocity sensor."},
    SideText{"drive", "Effect between the current and the torque sensor."},
};
constexpr const SideText& text_of(Side side) { return kSideTexts[static_cast<std::size_t>(side)]; }

/// The unit of a scale's ranges. Empty: the parameter's own unit, which is the same for every joint.
struct ScaleText {
  const char* name;    ///< for tables
  const char* phrase;  ///< for robot files
};
inline constexpr std::array kScaleTexts{
    ScaleText{"", ""},
    ScaleText{"largest current", "the valve's current_max_A"},
    ScaleText{"full push", "the supply pressure times the larger area"},
    ScaleText{"stroke", "the stroke"},
    ScaleText{"full speed", "the speed that the full valve gives"},
    ScaleText{"", ""},
    ScaleText{"", ""},
    ScaleText{"full flow / supply pressure", "the full valve's flow at supply pressure over that pressure"},
    ScaleText{"supply pressure / full flow", "the supply pressure over the full valve's flow at it"},
    ScaleText{"the model's", "the mass or inertia of the swing load"},
    ScaleText{"the model's, or 0.01 full push / full speed",
              "the damping of the swing load, or a hundredth of full push over full speed"},
    ScaleText{"the model's, or 0.2 full push / stroke",
              "the stiffness of the swing load, or a fifth of full push over stroke"},
    ScaleText{"stiffness / stroke^2",
              "the stiffness of the swing load, or a fifth of full push over stroke, over the stroke's square"},
    ScaleText{"the model's", "the inertia of the rotor"},
    ScaleText{"the model's, or (2 pi 100 Hz)^2 rotor", "the spring, or that on which the rotor swings at 100 Hz"},
};
static_assert(kScaleTexts.size() == static_cast<std::size_t>(Scale::kGearStiffness) + 1,
              "a text per scale, in their order");
constexpr const ScaleText& text_of(Scale scale) { return kScaleTexts[static_cast<std::size_t>(scale)]; }

}  // namespace farrier::plant
