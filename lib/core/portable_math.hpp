#pragma once

#include <bit>
#include <cstdint>

/// The functions of the C library whose results reach a trace, from +, -, *, / and sqrt alone. The C library picks a
/// variant by the processor, and variants differ in the last bit. "To e" bounds the error beside the exact value.
namespace farrier::portable_math {

/// Largest angle of sine and cosine (rad).
inline constexpr double kLargestAngle = 1e6;

struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle (rad) within [-1e6, 1e6], each to 3e-16 absolutely. Larger and non-finite angles give
/// NaN.
SineCosine sine_cosine(double angle_rad) noexcept;
double sine(double angle_rad) noexcept;
double cosine(double angle_rad) noexcept;

/// sin(2 pi x) and cos(2 pi x) to 4e-16 absolutely, for |x| < 2^51. Larger and non-finite x give NaN.
double sine_of_turns(double turns) noexcept;
double cosine_of_turns(double turns) noexcept;

/// atan2(y, x) (rad) to 5e-16, relatively below 0.5 rad. NaN and infinity give NaN.
double arc_tangent(double y, double x) noexcept;

/// Angle (rad, in [0, pi]) of a cosine, to 1e-15. Arguments beyond [-1, 1] act as the nearer end. NaN gives NaN.
double arc_cosine(double cosine) noexcept;

/// ln x to 4e-16 of its value. Zero gives -infinity; negative x and NaN give NaN.
double logarithm(double x) noexcept;

/// e^x to 2e-15 of its value; 0 below -700, infinity above 700. NaN gives NaN.
double exponential(double x) noexcept;

/// base^exponent for base > 0, to 2e-15 (1 + |exponent ln base|) of its value. Base 0 gives 0 for a positive exponent.
double power(double base, double exponent) noexcept;

/// sqrt(x^2 + y^2) to 3e-16 of its value, for sizes in [1e-150, 1e150] or 0.
double hypotenuse(double x, double y) noexcept;

/// Returns exp(-x) for x >= 0, to 2e-15 of its value. Returns 0 for x > 700, where the result nears the smallest normal
/// number. NaN and negative x act as 0, which gives 1.
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

}  // namespace farrier::portable_math
