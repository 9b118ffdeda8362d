#include "body/engine/own_math.hpp"

#include <cmath>
#include <limits>

#include "core/portable_math.hpp"

namespace farrier::body::own_math {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void sine_cosine(double x, double* sine, double* cosine) noexcept {
  const portable::SineCosine both = portable::sincos(x);
  *sine = both.sine;
  *cosine = both.cosine;
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
