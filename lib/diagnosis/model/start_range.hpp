#pragma once

#include <algorithm>

#include "plant/terms/term.hpp"

namespace farrier::diagnosis {

/// The number of the parameter's range that is nearest to `fitted`.
inline double within_range(const plant::Parameter& parameter, double fitted) noexcept {
  return std::clamp(fitted, parameter.low, parameter.high);
}

}  // namespace farrier::diagnosis
