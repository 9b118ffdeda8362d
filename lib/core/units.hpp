#pragma once

#include <numbers>

namespace farrier {

// Units in which people read hydraulics and angles.

inline constexpr double kPascalPerBar = 1e5;
inline constexpr double kPascalPerPsi = 6894.757;
inline constexpr double kLitrePerMinute = 60e3;               ///< litres per minute of a cubic metre per second
inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< of a radian

}  // namespace farrier
