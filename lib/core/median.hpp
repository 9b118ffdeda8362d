#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace farrier {

/// The middle value, or the mean of the two in the middle; NaN of none.
inline double median(std::vector<double> values) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::size_t half = values.size() / 2;
  std::ranges::sort(values);
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The same; 0 of none.
inline double median_or_zero(std::vector<double> values) { return values.empty() ? 0.0 : median(std::move(values)); }

}  // namespace farrier
