#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace farrier::plant {

/// 2^(-i/32) as doubles, i = 0 .. 31.
inline constexpr std::array<double, 32> kRootsOfHalf = [] {
  constexpr double kLn2 = 0.69314718055994530942;
  std::array<double, 32> roots{};
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const double r = kLn2 * static_cast<double>(i) / 32.0;
    double series = 1.0;  // Taylor; the first term left out is below (ln 2)^20 / 20! = 3e-22
    for (int k = 19; k >= 1; --k) {
      series = 1.0 - r * series / k;
    }
    roots[i] = series;
  }
  return roots;
}();

/// Returns exp(-x) for x >= 0, to 1e-15 of its value, from +, -, * alone: a trace must not depend on a C library.
/// Returns 0 for x > 700, where the result nears the smallest normal number. NaN and negative x act as 0, which gives
/// 1. After Tang (1989): a table and a short polynomial.
inline double exponential_decay(double x) noexcept {
  if (!(x > 0.0)) {
    return 1.0;
  }
  if (x > 700.0) {
    return 0.0;
  }
  // exp(-x) = 2^(-n/32) exp(-r), |r| <= ln 2 / 64; ln 2 / 32 as two doubles, the first short enough that n times it is
  // exact.
  constexpr double kLn2High = 0.693147180369123816490 / 32.0;
  constexpr double kLn2Low = 1.90821492927058770002e-10 / 32.0;
  constexpr double kInverseLn2 = 1.44269504088896338700 * 32.0;
  const int n = static_cast<int>(x * kInverseLn2 + 0.5);
  const double y = (n * kLn2High - x) + n * kLn2Low;
  // Taylor, in Estrin's order; the first term left out is below (ln 2 / 64)^7 / 7! = 4e-18.
  const double y2 = y * y;
  const double rest =
      (y + y2 * (1.0 / 2 + y * (1.0 / 6))) + y2 * y2 * ((1.0 / 24 + y * (1.0 / 120)) + y2 * (1.0 / 720));
  const double root = kRootsOfHalf[static_cast<unsigned>(n) % 32];
  return (root + root * rest) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - (n >> 5)) << 52);
}

}  // namespace farrier::plant
