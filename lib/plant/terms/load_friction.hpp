#pragma once

#include "plant/terms/load_contact.hpp"

namespace farrier::plant {

/// Coulomb and Stribeck friction between load and frame, Hubacher (2014), 9.3.1, by a contact that sticks. Neutral at
/// 0.
template <class T>
class LoadFriction {
 public:
  static constexpr std::array kParameters = kContactParameters;
  static constexpr EffectInfo kInfo{
      "load_friction", Side::kLoad, false, false, kParameters, "The load sticks and slips on its guides.", true};

  LoadFriction(const T* fitted, const Scales& scales, double step_s) noexcept : contact_(fitted, scales, step_s) {}

  void on_load(LoadMoment<T>& now) noexcept { contact_.on_load(now); }
  void after_load(const T& mean_velocity) noexcept { contact_.after_load(mean_velocity); }

 private:
  LoadContact<T> contact_;
};

}  // namespace farrier::plant
