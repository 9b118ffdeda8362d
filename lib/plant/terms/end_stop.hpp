#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// End stops nearer than the stroke's ends: on the piston, left of the load cell, that push and damp and
/// never pull. Neutral at 0.
template <class T>
class EndStop {
 public:
  static constexpr std::array kParameters{
      Parameter{"inset_m", "inset_rad", "m", "rad", Scale::kLength, false, 0.0, 0.5, {0.0, 0.0},
                "How far inside the ends of the stroke they stand."},
      Parameter{"stiffness_N_m", "stiffness_Nm_rad", "N/m", "Nm/rad", Scale::kStiffness, false, 1.0, 1e5,
                {500.0, 500.0}, "Their stiffness."},
      Parameter{"relaxation_s", "relaxation_s", "s", "s", Scale::kSecond, false, 0.0, 0.02, {0.0005, 0.0005},
                "Their damping over their stiffness."}};
  static constexpr EffectInfo kInfo{"end_stop", Side::kValveAndOil, false, false, kParameters,
                                    "The piston meets end stops before the stroke ends."};

  EndStop(const T* fitted, const Scales& scales, double) noexcept
      : low_(fitted[0] * scales.of(Scale::kLength)),
        high_(scales.of(Scale::kLength) - low_),
        stiffness_(fitted[1] * scales.of(Scale::kStiffness)),
        relaxation_s_(fitted[2]) {}

  void on_piston(PistonMoment<T>& now) noexcept {
    if (now.position < low_) {
      const T push = low_ - now.position - relaxation_s_ * now.velocity;
      now.force += push > 0.0 ? T(stiffness_ * push) : T(0.0);
    } else if (now.position > high_) {
      const T push = now.position - high_ + relaxation_s_ * now.velocity;
      now.force -= push > 0.0 ? T(stiffness_ * push) : T(0.0);
    }
  }

 private:
  T low_, high_, stiffness_, relaxation_s_;
};

}  // namespace farrier::plant
