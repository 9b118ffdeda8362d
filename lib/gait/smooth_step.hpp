#pragma once

namespace farrier::gait {

/// A scalar of one argument with its first and second derivative with respect to that argument.
struct Smooth {
  double value;
  double slope;
  double curvature;
};

/// Step from 0 (x <= 0) to 1 (x >= 1) whose first three derivatives vanish at both ends, the polynomial of degree 7:
/// step(x) + step(1 - x) = 1. Made of products and sums only, so every machine computes the same bits.
Smooth smooth_step(double x) noexcept;

/// Hump from 0 over 1 (at x = 1/2) back to 0, first three derivatives zero at both ends: 256 x^4 (1 - x)^4.
Smooth smooth_hump(double x) noexcept;

}  // namespace farrier::gait
