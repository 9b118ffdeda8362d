#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::control {

inline constexpr int kMaxBalancingSweeps = 12;

/// Powers of two s_i that bring the rows and columns of diag(1/s) m diag(s) to like size (Osborne 1960); `m` becomes
/// that matrix. Powers of two, so that balancing and its undoing add no rounding. With kHeldInput the last row is zero
/// and its state may be scaled freely, so its column is shrunk to one. Entries finite.
template <bool kHeldInput, int N>
Eigen::Matrix<double, N, 1> balance(Eigen::Matrix<double, N, N>& m) noexcept {
  Eigen::Matrix<double, N, 1> scale = Eigen::Matrix<double, N, 1>::Ones();
  for (int sweep = 0; sweep < kMaxBalancingSweeps; ++sweep) {
    bool changed = false;
    for (int i = 0; i < N; ++i) {
      const double diagonal = std::abs(m(i, i));
      const double column = m.col(i).template lpNorm<1>() - diagonal;
      const double row = m.row(i).template lpNorm<1>() - diagonal;
      const double ratio = kHeldInput && i == N - 1 ? 1.0 / column : std::sqrt(row / column);
      if (!(ratio > 0.0) || !std::isfinite(ratio)) {
        continue;
      }
      const int exponent = portable::nearest_exponent(ratio);
      if (exponent != 0) {
        const double factor = std::ldexp(1.0, exponent);
        m.col(i) *= factor;
        m.row(i) /= factor;
        scale(i) *= factor;
        changed = true;
      }
    }
    if (!changed) {
      break;
    }
  }
  return scale;
}

}  // namespace farrier::control
