#pragma once

namespace farrier {

// Units in which people read hydraulics.

inline constexpr double kPascalPerBar = 1e5;
inline constexpr double kLitrePerMinute = 60e3;  ///< litres per minute of a cubic metre per second

}  // namespace farrier
