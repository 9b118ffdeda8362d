#include "core/portable_math.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace farrier::portable {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// pi / 2 as a sum of two doubles, the first short enough that its multiples up to 2^20 are exact.
constexpr double kHalfPiHigh = 1.57079632673412561417;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

/// The nearest whole number for |x| < 2^51: from 2^52 on a double has no fraction.
double rounded(double x) noexcept {
  constexpr double kNoFraction = 0x1.8p52;
  return (x + kNoFraction) - kNoFraction;
}

/// Taylor series on [-pi/4, pi/4]; the first term left out is below 1e-16 of the sine and 1e-17.
double sine_series(double x) noexcept {
  constexpr double a = -1.0 / 6, b = a / -20, c = b / -42, d = c / -72, e = d / -110, f = e / -156, g = f / -210;
  const double y = x * x;
  return x + x * (y * (a + y * (b + y * (c + y * (d + y * (e + y * (f + y * g)))))));
}

double cosine_series(double x) noexcept {
  constexpr double a = 1.0 / 24, b = a / -30, c = b / -56, d = c / -90, e = d / -132, f = e / -182, g = f / -240;
  const double y = x * x;
  return 1.0 - y * (0.5 - y * (a + y * (b + y * (c + y * (d + y * (e + y * (f + y * g)))))));
}

/// sin(2 pi x) on [-1/4, 1/4] by its Taylor series, (-1)^n (2 pi)^(2n+1) / (2n+1)!. The first term left out is 1e-18.
double quarter_turn_sine(double x) noexcept {
  const double y = x * x;
  return x * (6.28318530717958647692528 +
              y * (-41.3417022403997602339684 +
                   y * (81.6052492760750542033976 +
                        y * (-76.7058597530613858416306 +
                             y * (42.0586939448976531449868 +
                                  y * (-15.0946425768229903918266 +
                                       y * (3.81995258484828212773379 +
                                            y * (-0.71812230177850051223174 +
                                                 y * (0.10422916220813984117271 +
                                                      y * (-0.01203158594212062723320 +
                                                           y * 0.00113092374825179618777))))))))));
}

/// x less the nearest whole number, exactly; NaN from 2^51 on.
double part_of_turn(double x) noexcept { return std::abs(x) < 0x1p51 ? x - rounded(x) : kNaN; }

}  // namespace

SineCosine sincos(double angle_rad) noexcept {
  if (!(std::abs(angle_rad) <= kLargestAngle)) {
    return {kNaN, kNaN};
  }
  const double quarters = rounded(angle_rad * (2.0 / std::numbers::pi));
  const double rest = (angle_rad - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
  const double s = sine_series(rest);
  const double c = cosine_series(rest);
  switch (static_cast<int>(quarters) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double sin(double angle_rad) noexcept { return sincos(angle_rad).sine; }
double cos(double angle_rad) noexcept { return sincos(angle_rad).cosine; }

double sin_of_turns(double turns) noexcept {
  const double part = part_of_turn(turns);
  return quarter_turn_sine(std::abs(part) > 0.25 ? std::copysign(0.5, part) - part : part);
}

double cos_of_turns(double turns) noexcept { return quarter_turn_sine(0.25 - std::abs(part_of_turn(turns))); }

// With t = min / max of |y| and |x|, atan t = t (pi/4 + 0.273 (1 - t)) to 4e-3 (Rajan, Wang, Inkol and Joyal 2006). The rest
//   e = (t cos a - sin a) / (cos a + t sin a) = tan(atan t - a)
// is added as e - e^3/3; two rounds leave 1e-26 of it.
double atan2(double y, double x) noexcept {
  const double u = std::abs(y);
  const double v = std::abs(x);
  const double larger = u > v ? u : v;
  if (!std::isfinite(u) || !std::isfinite(v)) {
    return kNaN;
  }
  const double t = larger == 0.0 ? 0.0 : (u > v ? v : u) / larger;
  double angle = t * (0.25 * std::numbers::pi + 0.273 * (1.0 - t));
  for (int round = 0; round < 2; ++round) {
    const SineCosine at = sincos(angle);
    const double e = (t * at.cosine - at.sine) / (at.cosine + t * at.sine);
    angle += e - e * e * e / 3.0;
  }
  angle = u > v ? 0.5 * std::numbers::pi - angle : angle;
  angle = std::signbit(x) ? std::numbers::pi - angle : angle;
  return std::copysign(angle, y);
}

double acos(double cosine) noexcept {
  if (cosine >= 1.0) {
    return 0.0;
  }
  if (cosine <= -1.0) {
    return std::numbers::pi;
  }
  // tan(angle / 2) = sqrt((1 - c) / (1 + c)), which keeps its digits near both ends
  return 2.0 * atan2(std::sqrt(1.0 - cosine), std::sqrt(1.0 + cosine));
}

}  // namespace farrier::portable
