#include "gait/smooth_step.hpp"

namespace farrier::gait {

Smooth smooth_step(double x) noexcept {
  if (!(x > 0.0)) {
    return {0.0, 0.0, 0.0};
  }
  if (x >= 1.0) {
    return {1.0, 0.0, 0.0};
  }
  const double w = x * (1.0 - x);
  // step = 35 x^4 - 84 x^5 + 70 x^6 - 20 x^7,  step' = 140 w^3,  step'' = 420 w^2 (1 - 2 x)
  const double value = x * x * x * x * (35.0 + x * (-84.0 + x * (70.0 - 20.0 * x)));
  return {value, 140.0 * w * w * w, 420.0 * w * w * (1.0 - 2.0 * x)};
}

Smooth smooth_hump(double x) noexcept {
  if (!(x > 0.0) || x >= 1.0) {
    return {0.0, 0.0, 0.0};
  }
  const double w = x * (1.0 - x);
  const double w_slope = 1.0 - 2.0 * x;
  // hump = 256 w^4,  hump' = 1024 w^3 w',  hump'' = 3072 w^2 w'^2 - 2048 w^3
  return {256.0 * w * w * w * w, 1024.0 * w * w * w * w_slope, w * w * (3072.0 * w_slope * w_slope - 2048.0 * w)};
}

}  // namespace farrier::gait
