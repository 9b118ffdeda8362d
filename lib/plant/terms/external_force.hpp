#pragma once

#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A constant force on the load, positive along +position: F_ext of Hubacher (2014) (2.24). Neutral at 0.
template <class T>
class ExternalForce {
 public:
  static constexpr std::array kParameters{
      Parameter{"force_N", "torque_Nm", "N", "Nm", Scale::kForce, false, -1.0, 1.0, {0.01, 0.01}, "The force."}};
  static constexpr EffectInfo kInfo{"external_force", Side::kLoad, false, true, kParameters,
                                    "A constant force acts on the load."};

  ExternalForce(const T* fitted, const Scales& scales, double) noexcept
      : force_(fitted[0] * scales.of(Scale::kForce)) {}

  void on_load(LoadMoment<T>& now) noexcept { now.external_force += force_; }

 private:
  T force_;
};

}  // namespace farrier::plant
