#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "plant/exponential.hpp"

namespace farrier::plant::portable {

// exp, log, pow and tanh of doubles from +, -, *, / alone: the plant simulates with the terms' own code, and what
// shapes a trace must not depend on a C library. A term says `using portable::exp;` and gets these for doubles; a
// number with derivatives brings its own, found by its type.

/// To 2e-15 of its value; 0 below -700, 1/exp(-700) above 700; NaN gives 1.
inline double exp(double x) noexcept { return x > 0.0 ? 1.0 / exponential_decay(x) : exponential_decay(-x); }

/// To 4e-16 absolutely and relatively, for normal x > 0; others give a number without meaning.
inline double log(double x) noexcept {
  // x = m 2^k with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh s, s = (m - 1) / (m + 1), |s| <= 0.1716.
  constexpr double kLn2 = 0.69314718055994530942;
  constexpr std::uint64_t kSqrtHalf = std::bit_cast<std::uint64_t>(0.70710678118654752440);
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const auto k = static_cast<std::int64_t>(bits - kSqrtHalf) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52));
  const double s = (m - 1.0) / (m + 1.0);
  const double square = s * s;
  // The first term left out is below 0.0295^12 / 25 = 2e-20.
  double series = 0.0;
  for (int n = 23; n >= 1; n -= 2) {
    series = series * square + 1.0 / n;
  }
  return static_cast<double>(k) * kLn2 + 2.0 * s * series;
}

/// For base > 0, to 2e-15 (1 + |exponent ln base|) of its value.
inline double pow(double base, double exponent) noexcept { return exp(exponent * log(base)); }

/// To 2e-16 absolutely.
inline double tanh(double x) noexcept {
  const double decay = exponential_decay(2.0 * std::abs(x));
  const double size = (1.0 - decay) / (1.0 + decay);
  return x < 0.0 ? -size : size;
}

}  // namespace farrier::plant::portable
