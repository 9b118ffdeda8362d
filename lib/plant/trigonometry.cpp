#include "plant/trigonometry.hpp"

#include <cmath>
#include <numbers>
#include <limits>

namespace farrier::plant {
namespace {

/// pi / 2 as a sum of two doubles, the first short enough that small multiples of it are exact.
constexpr double kHalfPiHigh = 1.57079632673412561417;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;
constexpr double kLargestAngle = 8.0;

/// Taylor series on [-pi/4, pi/4]; the first term left out is below 1e-17.
double sine_series(double x) noexcept {
  const double y = x * x;
  return x * (1.0 - y / 6.0 * (1.0 - y / 20.0 * (1.0 - y / 42.0 * (1.0 - y / 72.0 * (1.0 - y / 110.0 *
         (1.0 - y / 156.0 * (1.0 - y / 210.0)))))));
}

double cosine_series(double x) noexcept {
  const double y = x * x;
  return 1.0 - y / 2.0 * (1.0 - y / 12.0 * (1.0 - y / 30.0 * (1.0 - y / 56.0 * (1.0 - y / 90.0 *
         (1.0 - y / 132.0 * (1.0 - y / 182.0 * (1.0 - y / 240.0)))))));
}

}  // namespace

SineCosine sine_cosine(double angle_rad) noexcept {
  if (!(std::abs(angle_rad) <= kLargestAngle)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  const double turns = angle_rad / (0.5 * std::numbers::pi);
  const int quarters = static_cast<int>(turns < 0.0 ? turns - 0.5 : turns + 0.5);
  const double rest = (angle_rad - quarters * kHalfPiHigh) - quarters * kHalfPiLow;
  const double s = sine_series(rest);
  const double c = cosine_series(rest);
  switch (quarters & 3) {
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

double arc_cosine(double cosine) noexcept {
  if (cosine >= 1.0) {
    return 0.0;
  }
  if (cosine <= -1.0) {
    return std::numbers::pi;
  }
  // Abramowitz and Stegun (1964), 4.4.45, good to 7e-5; two Newton steps square that twice.
  const double x = std::abs(cosine);
  const double first =
      std::sqrt(1.0 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x)));
  double angle = cosine < 0.0 ? std::numbers::pi - first : first;
  for (int iteration = 0; iteration < 2; ++iteration) {
    const SineCosine at = sine_cosine(angle);
    angle += (at.cosine - cosine) / at.sine;
  }
  return angle;
}

}  // namespace farrier::plant
