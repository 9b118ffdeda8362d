#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Another spring behind the load, C and x_eq of Hubacher (2014) (2.24). Where the nominal load has a spring its slack
/// position stays; a spring that the nominal load does not know may be slack anywhere. Neutral at the nominal one.
template <class T>
class LoadStiffness {
 public:
  static constexpr std::array kParameters{
      Parameter{"stiffness_N_m", "stiffness_Nm_rad", "N/m", "Nm/rad", Scale::kStiffness, false, 0.0, 20.0,
                {1.05, 0.05}, "Stiffness, C."},
      Parameter{"slack_position_m", "slack_position_rad", "m", "rad", Scale::kLength, false, -0.5, 1.5, {0.5, 0.5},
                "Where the spring is slack, x_eq."}};
  static constexpr EffectInfo kInfo{"load_stiffness", Side::kLoad, true, true, kParameters,
                                    "The load is held by another spring than the model's."};

  LoadStiffness(const T* fitted, const Scales& scales, double) noexcept
      : stiffness_(fitted[0] * scales.of(Scale::kStiffness)), slack_position_(fitted[1] * scales.of(Scale::kLength)) {}

  void on_load(LoadMoment<T>& now) noexcept {
    now.stiffness = stiffness_;
    now.slack_position = slack_position_;
  }

 private:
  T stiffness_, slack_position_;
};

}  // namespace farrier::plant
