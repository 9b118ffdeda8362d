#pragma once

#include <bit>
#include <cstdint>

namespace farrier::plant {

/// Returns exp(-x) for x >= 0, to 1e-15 of its value, from +, -, * alone: a trace must not depend on a C library.
/// Returns 0 for x > 700, where the result nears the smallest normal number. NaN and negative x act as 0, which gives
/// 1.
inline double exponential_decay(double x) noexcept {
  if (!(x > 0.0)) {
    return 1.0;
  }
  if (x > 700.0) {
    return 0.0;
  }
  // exp(-x) = 2^-n exp(-r), |r| <= ln 2 / 2; ln 2 as two doubles, the first short enough that n times it is exact.
  constexpr double kLn2High = 0.693147180369123816490;
  constexpr double kLn2Low = 1.90821492927058770002e-10;
  constexpr double kInverseLn2 = 1.44269504088896338700;
  const int n = static_cast<int>(x * kInverseLn2 + 0.5);
  const double r = (x - n * kLn2High) - n * kLn2Low;
  // Taylor; the first term left out is below (ln 2 / 2)^14 / 14! = 4e-18.
  double series = 1.0;
  for (int k = 13; k >= 1; --k) {
    series = 1.0 - r * series / k;
  }
  return series * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - n) << 52);
}

}  // namespace farrier::plant
