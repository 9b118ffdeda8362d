#include "body/engine/own_math.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "plant/trigonometry.hpp"

namespace farrier::body::own_math {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double sine(double x) noexcept { return plant::sine_cosine(x).sine; }

double cosine(double x) noexcept { return plant::sine_cosine(x).cosine; }

void sine_cosine(double x, double* sine, double* cosine) noexcept {
  const plant::SineCosine both = plant::sine_cosine(x);
  *sine = both.sine;
  *cosine = both.cosine;
}

// With t = min / max of |y| and |x|, atan t = t (pi/4 + 0.273 (1 - t)) to 4e-3 (Rajan, Wang, Inkol and Joyal 2006). The rest
//   e = (t cos a - sin a) / (cos a + t sin a) = tan(atan t - a)
// is added as e - e^3/3; two rounds leave 1e-26 of it.
double arc_tangent(double y, double x) noexcept {
  const double u = std::abs(y);
  const double v = std::abs(x);
  const double larger = u > v ? u : v;
  if (!std::isfinite(u) || !std::isfinite(v)) {
    return kNaN;
  }
  const double t = larger == 0.0 ? 0.0 : (u > v ? v : u) / larger;
  double angle = t * (0.25 * std::numbers::pi + 0.273 * (1.0 - t));
  for (int round = 0; round < 2; ++round) {
    const plant::SineCosine at = plant::sine_cosine(angle);
    const double e = (t * at.cosine - at.sine) / (at.cosine + t * at.sine);
    angle += e - e * e * e / 3.0;
  }
  angle = u > v ? 0.5 * std::numbers::pi - angle : angle;
  angle = std::signbit(x) ? std::numbers::pi - angle : angle;
  return std::copysign(angle, y);
}

double power(double base, double exponent) noexcept {
  constexpr double kLargest = 16.0;
  if (!(exponent >= 0.0 && exponent <= kLargest) || exponent != std::floor(exponent)) {
    return kNaN;
  }
  double product = 1.0;
  for (int factor = 0; factor < static_cast<int>(exponent); ++factor) {
    product *= base;
  }
  return product;
}

double forbidden(double) noexcept { return kNaN; }

}  // namespace farrier::body::own_math
