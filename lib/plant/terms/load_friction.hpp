#pragma once

#include "plant/terms/contact_parameters.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Coulomb and Stribeck friction between load and frame, Hubacher (2014), 9.3.1, by a contact that sticks. Neutral at
/// 0.
template <class T>
class LoadFriction {
 public:
  static constexpr std::array kParameters = kContactParameters;
  static constexpr EffectInfo kInfo{
      "load_friction", Side::kLoad, false, false, kParameters, "The load sticks and slips on its guides.", true};

  LoadFriction(const T* fitted, const Scales& scales, double step_s) noexcept
      : contact_(fitted[0] * scales.of(Scale::kForce), fitted[0] * scales.of(Scale::kForce) * fitted[1],
                 fitted[2] * scales.of(Scale::kSpeed), fitted[3] * scales.of(Scale::kLength),
                 fitted[4] * scales.of(Scale::kDamping)),
        step_s_(step_s) {}

  // The mean of the contact's force over the step: half of what it was and half of what it will be.
  void on_load(LoadMoment<T>& now) noexcept {
    step_ = contact_.over(now.velocity, step_s_);
    const T damped = contact_.damping_time() / step_s_;  // share of the force's change
    now.hold += (0.5 * (1.0 + step_.keep) + damped * (step_.keep - 1.0)) * force_;
    now.slope += (0.5 + damped) * step_.give;
  }
  void after_load(const T& mean_velocity) noexcept { force_ = step_.keep * force_ + step_.give * mean_velocity; }

 private:
  DryContact<T> contact_;
  double step_s_;
  typename DryContact<T>::Step step_{};
  T force_ = T(0.0);
};

}  // namespace farrier::plant
