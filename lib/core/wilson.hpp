#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace farrier {

/// Bounds of a share.
struct WilsonInterval {
  double low, high;
};

/// Bounds of a share of `count` in `of`, at 95 % (Wilson 1927); 0 and 1 of none.
inline WilsonInterval wilson_interval(std::size_t count, std::size_t of) noexcept {
  constexpr double z = 1.959963984540054;
  if (of == 0) {
    return {0.0, 1.0};
  }
  const auto n = static_cast<double>(of);
  const double share = static_cast<double>(count) / n;
  const double middle = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half = z / (1.0 + z * z / n) * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace farrier
