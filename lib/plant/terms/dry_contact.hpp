#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Bristles in a dry contact, for effects of friction: Canudas de Wit, Olsson, Astrom and Lischinsky (1995), (1) to
/// (3), written in their force f as plant/effects/friction.hpp has it: f' = s (v - |v| f / g(v)). Over a step at
/// constant speed that is f e^-a + s h phi(a) v, a = s |v| h / g, phi(a) = (1 - e^-a) / a.
template <class T>
struct DryContact {
  /// Steady friction at a speed: Stribeck's curve g.
  T steady(const T& speed) const noexcept {
    using std::exp;
    const T ratio = speed / stribeck_velocity;
    return coulomb * (1.0 + (breakaway_ratio - 1.0) * exp(-ratio * ratio));
  }
  /// Coefficients of a step, f+ = keep f + give v: the rest of f, and the gain per speed.
  struct Step {
    T keep, give;
  };
  Step over(const T& speed, double step_s) const noexcept {
    using std::abs, std::exp;
    const T stiffness = coulomb * breakaway_ratio / presliding;
    const T a = stiffness * abs(speed) * step_s / steady(speed);
    const T keep = exp(-a);
    const T phi = a > 1e-6 ? T((1.0 - keep) / a) : T(1.0 - 0.5 * a);
    return {keep, stiffness * step_s * phi};
  }

  T coulomb, breakaway_ratio, stribeck_velocity;
  double presliding;  ///< way over which the contact bends before it slides, m or rad
};

/// Parameters of effects of friction.
inline constexpr std::array kContactParameters{
    Parameter{"coulomb_N", "coulomb_Nm", "N", "Nm", Scale::kForce, false, 1e-6, 0.5, {0.01, 0.05},
              "Friction in motion."},
    Parameter{"breakaway_ratio", "breakaway_ratio", "1", "1", Scale::kOne, false, 1.0, 2.5, {1.3, 1.3},
              "Friction that holds at rest, over that in motion."},
    Parameter{"stribeck_velocity_m_s", "stribeck_velocity_rad_s", "m/s", "rad/s", Scale::kSpeed, false, 0.001, 0.1,
              {0.01, 0.01}, "Speed over which the one falls to the other."}};

/// Share of the stroke over which contacts bend: 10 um of 80 mm.
inline constexpr double kPreslidingShare = 1.25e-4;

}  // namespace farrier::plant
