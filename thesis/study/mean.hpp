#pragma once

#include <cstddef>
#include <span>

namespace farrier::thesis {

/// Mean of value(i) over i in [from, to); NaN of none.
template <class Value>
double mean_over(std::size_t from, std::size_t to, const Value& value) {
  double sum = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    sum += value(i);
  }
  return sum / static_cast<double>(to - from);
}

/// Mean of the values; NaN of none.
inline double mean(std::span<const double> values) {
  return mean_over(0, values.size(), [&](std::size_t i) { return values[i]; });
}

}  // namespace farrier::thesis
