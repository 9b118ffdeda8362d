#pragma once

#include "plant/terms/dry_contact.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Coulomb and Stribeck friction of the piston's seals, left of the load cell: a contact that sticks. Neutral at 0.
template <class T>
class PistonFriction {
 public:
  static constexpr std::array kParameters{
      Parameter{"coulomb_N", "coulomb_Nm", "N", "Nm", Scale::kForce, false, 1e-6, 0.5, {0.01, 0.05},
                "Friction in motion."},
      Parameter{"breakaway_ratio", "breakaway_ratio", "1", "1", Scale::kOne, false, 1.0, 2.5, {1.3, 1.3},
                "Friction that holds at rest, over that in motion."},
      Parameter{"stribeck_velocity_m_s", "stribeck_velocity_rad_s", "m/s", "rad/s", Scale::kSpeed, false, 0.001, 0.1,
                {0.01, 0.01}, "Speed over which the one falls to the other."}};
  static constexpr EffectInfo kInfo{"piston_friction", Side::kValveAndOil, false, false, kParameters};

  PistonFriction(const T* fitted, const Scales& scales, double) noexcept
      : contact_{fitted[0] * scales.of(Scale::kForce), fitted[1], fitted[2] * scales.of(Scale::kSpeed),
                 kPreslidingShare * scales.of(Scale::kLength)} {}

  void on_piston(PistonMoment<T>& now) noexcept {
    const auto step = contact_.over(T(now.velocity), now.period_s);
    force_ = step.keep * force_ + step.give * now.velocity;
    now.force -= force_;
  }

 private:
  DryContact<T> contact_;
  T force_ = T(0.0);
};

}  // namespace farrier::plant
