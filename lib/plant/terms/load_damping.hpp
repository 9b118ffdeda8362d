#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Another viscous friction of the load, d_l of Hubacher (2014) (2.24). Neutral at the nominal one.
template <class T>
class LoadDamping {
 public:
  static constexpr std::array kParameters{
      Parameter{"damping_Ns_m", "damping_Nms_rad", "Ns/m", "Nms/rad", Scale::kDamping, false, 0.0, 20.0,
                {1.05, 1.05}, "Another viscous friction of the load."}};
  static constexpr EffectInfo kInfo{"load_damping", Side::kLoad, true, true, kParameters,
                                    "The load has another viscous friction than the model."};

  LoadDamping(const T* fitted, const Scales& scales, double) noexcept
      : damping_(fitted[0] * scales.of(Scale::kDamping)) {}

  void on_load(LoadMoment<T>& now) noexcept { now.damping = damping_; }

 private:
  T damping_;
};

}  // namespace farrier::plant
