#pragma once

#include <array>

#include "control/design/lqr.hpp"

namespace farrier::control {

/// Sampled plant as ratios of polynomials in z, coefficients from z^0 upwards: state = numerator(z) / denominator(z) u.
/// The compliant form has two states, velocity and force, and a position numerator of zero, as its design sees it.
struct PlantPolynomials {
  std::array<double, 4> denominator;  ///< monic, of degree 3 or 2
  std::array<double, 3> position;
  std::array<double, 3> velocity;
  std::array<double, 3> force;
};

/// By adj(zI - A) = z^2 I + z (A + c_2 I) + (A^2 + c_2 A + c_1 I) (Faddeev, Leverrier); in the model's units.
PlantPolynomials plant_polynomials(const DiscreteModel& model, Form form) noexcept;

}  // namespace farrier::control
