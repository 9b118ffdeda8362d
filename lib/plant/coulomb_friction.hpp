#pragma once

#include <cmath>

namespace farrier::plant {

/// Coulomb friction without a state, F_c v / sqrt(v^2 + v_c^2), N or Nm: smooth and odd, of the sign of v, and 0.7 F_c
/// at the slip velocity v_c > 0. For models that a filter or a controller carries along; a load that truly sticks has a
/// DryContact.
inline double coulomb_friction(double coulomb, double velocity, double slip_velocity) noexcept {
  return coulomb * velocity / std::sqrt(velocity * velocity + slip_velocity * slip_velocity);
}

/// The same per F_c, and its derivative by the velocity.
struct SmoothSign {
  double value, slope;
};
inline SmoothSign smooth_sign(double velocity, double slip_velocity) noexcept {
  const double square = velocity * velocity + slip_velocity * slip_velocity;
  const double root = std::sqrt(square);
  return {velocity / root, slip_velocity * slip_velocity / (square * root)};
}

}  // namespace farrier::plant
