#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

/// The functions of the C library whose results reach a trace, from +, -, *, / and sqrt alone. The C library picks a
/// variant by the processor, and variants differ in the last bit. "To e" bounds the error beside the exact value.
///
/// A template of plain and derivative-carrying numbers says `using portable::exp;` and gets these for doubles; the
/// others bring their own, found by their type.
namespace farrier::portable {

/// Largest angle of sine and cosine (rad).
inline constexpr double kLargestAngle = 1e6;

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle (rad) within [-1e6, 1e6], each to 3e-16 absolutely. Larger and non-finite angles give
/// NaN.
SineCosine sincos(double angle_rad) noexcept;
double sin(double angle_rad) noexcept;
double cos(double angle_rad) noexcept;

/// sin(2 pi x) and cos(2 pi x) to 4e-16 absolutely, for |x| < 2^51. Larger and non-finite x give NaN.
double sin_of_turns(double turns) noexcept;
double cos_of_turns(double turns) noexcept;

/// Angle (rad, in [-pi, pi]) of the point (x, y), to 6e-16, relatively below 0.5 rad. NaN and infinity give NaN.
double atan2(double y, double x) noexcept;

/// Angle (rad, in [0, pi]) of a cosine, to 1e-15. Arguments beyond [-1, 1] act as the nearer end. NaN gives NaN.
double acos(double cosine) noexcept;

/// Whole n whose 2^n is nearest to finite x > 0 by ratio. Exact, but for x within 1e-16 of the middle of two.
inline int nearest_exponent(double x) noexcept {
  constexpr double kSqrtHalf = 0.70710678118654752440;
  int exponent = 0;
  return std::frexp(x, &exponent) < kSqrtHalf ? exponent - 1 : exponent;
}

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

/// ln 2 as a sum of two doubles, the first short enough that its multiples up to 2^20 are exact.
inline constexpr double kLn2High = 0.693147180369123816490;
inline constexpr double kLn2Low = 1.90821492927058770002e-10;

/// exp(-x) for x >= 0, to 1e-15 of its value. Returns 0 for x > 700, where the result nears the smallest normal number.
/// NaN and negative x act as 0, which gives 1. After Tang (1989): a table and a short polynomial.
inline double exponential_decay(double x) noexcept {
  if (!(x > 0.0)) {
    return 1.0;
  }
  if (x > 700.0) {
    return 0.0;
  }
  // exp(-x) = 2^(-n/32) exp(-r), |r| <= ln 2 / 64
  constexpr double kInverseLn2 = 1.44269504088896338700 * 32.0;
  const int n = static_cast<int>(x * kInverseLn2 + 0.5);
  const double y = (n * (kLn2High / 32.0) - x) + n * (kLn2Low / 32.0);
  // Taylor, in Estrin's order; the first term left out is below (ln 2 / 64)^7 / 7! = 4e-18.
  const double y2 = y * y;
  const double rest =
      (y + y2 * (1.0 / 2 + y * (1.0 / 6))) + y2 * y2 * ((1.0 / 24 + y * (1.0 / 120)) + y2 * (1.0 / 720));
  const double root = kRootsOfHalf[static_cast<unsigned>(n) % 32];
  return (root + root * rest) * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - (n >> 5)) << 52);
}

/// e^x to 2e-15 of its value; 0 below -700, infinity above 700. NaN gives NaN.
inline double exp(double x) noexcept {
  return x > 0.0 ? 1.0 / exponential_decay(x) : x <= 0.0 ? exponential_decay(-x) : x;
}

/// ln x to 4e-16 of its value. Zero gives -infinity; negative x and NaN give NaN.
inline double log(double x) noexcept {
  using Limits = std::numeric_limits<double>;
  if (!(x >= Limits::min() && x <= Limits::max())) {
    constexpr double kScale = 0x1p54;
    const bool subnormal = x > 0.0 && x < 1.0;
    return subnormal  ? log(x * kScale) - 54.0 * (kLn2High + kLn2Low)
           : x == 0.0 ? -Limits::infinity()
           : x > 0.0  ? x
                      : Limits::quiet_NaN();
  }
  // x = m 2^k with m in [sqrt(1/2), sqrt(2)); ln m = 2 artanh s, s = (m - 1) / (m + 1), |s| <= 0.1716.
  constexpr std::uint64_t kSqrtHalf = std::bit_cast<std::uint64_t>(0.70710678118654752440);
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const auto k = static_cast<std::int64_t>(bits - kSqrtHalf) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52));
  const double s = (m - 1.0) / (m + 1.0);
  const double y = s * s;
  // artanh(s) / s - 1; the first term left out is below 0.0295^11 / 23 = 7e-19.
  const double series =
      y * (1.0 / 3 +
           y * (1.0 / 5 +
                y * (1.0 / 7 +
                     y * (1.0 / 9 +
                          y * (1.0 / 11 +
                               y * (1.0 / 13 + y * (1.0 / 15 + y * (1.0 / 17 + y * (1.0 / 19 + y * (1.0 / 21))))))))));
  const auto octaves = static_cast<double>(k);
  return octaves * kLn2High + (2.0 * s + (2.0 * s * series + octaves * kLn2Low));
}

/// base^exponent for base > 0, to 2e-15 (1 + |exponent ln base|) of its value. Base 0 gives 0 for a positive exponent.
inline double pow(double base, double exponent) noexcept { return exp(exponent * log(base)); }

/// To 4e-16 absolutely.
inline double tanh(double x) noexcept {
  const double decay = exponential_decay(2.0 * std::abs(x));
  const double size = (1.0 - decay) / (1.0 + decay);
  return x < 0.0 ? -size : size;
}

/// cosh x to 4e-15 of its value; infinity beyond 700.
inline double cosh(double x) noexcept {
  const double up = exp(std::abs(x));
  return 0.5 * (up + 1.0 / up);
}

/// sinh x to 6e-15 of its value; infinity beyond 700.
inline double sinh(double x) noexcept {
  const double y = x * x;
  if (y < 1.0) {
    double series = 1.0;  // Taylor; the first term left out is below 1 / 19! = 8e-18
    for (int k = 16; k >= 2; k -= 2) {
      series = 1.0 + series * y / (k * (k + 1));
    }
    return x * series;
  }
  const double up = exp(x);
  return 0.5 * (up - 1.0 / up);
}

}  // namespace farrier::portable
