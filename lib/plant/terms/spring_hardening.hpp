#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A spring stiffer away from where it is slack: C d + k d^3 for d = x - x_eq (Duffing 1918). Where the nominal load
/// has no spring it is slack where it is found to be. Neutral at 0.
template <class T>
class SpringHardening {
 public:
  static constexpr std::array kParameters{
      Parameter{"cubic_N_m3", "cubic_Nm_rad3", "N/m^3", "Nm/rad^3", Scale::kCubic, false, -5000.0, 5000.0,
                {1.0, 60.0}, "Cubic stiffness, k."},
      Parameter{"slack_position_m", "slack_position_rad", "m", "rad", Scale::kLength, false, -0.5, 1.5, {0.5, 0.5},
                "Where the spring is slack, x_eq."}};
  static constexpr EffectInfo kInfo{"spring_hardening", Side::kLoad, false, true, kParameters,
                                    "The load's spring is stiffer, or softer, the further it is bent."};

  SpringHardening(const T* fitted, const Scales& scales, double) noexcept
      : cubic_(fitted[0] * scales.of(Scale::kCubic)), slack_position_(fitted[1] * scales.of(Scale::kLength)) {}

  void on_load(LoadMoment<T>& now) noexcept {
    const T way = now.position - slack_position_;
    now.external_force -= cubic_ * way * way * way;
  }

 private:
  T cubic_, slack_position_;
};

}  // namespace farrier::plant
