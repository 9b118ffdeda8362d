#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace farrier::web {

/// The number rounded to whole `digit`, as 0.1, so that no letters are sent that no eye sees; null if it is not finite.
inline nlohmann::json rounded(double value, double digit) {
  return std::isfinite(value) ? nlohmann::json(std::round(value / digit) / std::round(1.0 / digit))
                              : nlohmann::json(nullptr);
}

}  // namespace farrier::web
