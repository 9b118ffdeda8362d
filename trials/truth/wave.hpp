#pragma once

#include <cmath>

namespace farrier::truth {

/// size sin(phase), without the sine where there is no wave: machines ask for it at every step.
inline double wave(double size, double phase) noexcept { return size != 0.0 ? size * std::sin(phase) : 0.0; }

}  // namespace farrier::truth
