#pragma once

#include "plant/terms/contact_parameters.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// Coulomb and Stribeck friction, with bristles, of the piston's seals, left of the load cell: a contact that sticks. Neutral at 0.
template <class T>
class PistonFriction {
 public:
  static constexpr std::array kParameters = kContactParameters;
  static constexpr EffectInfo kInfo{
      "piston_friction", Side::kValveAndOil, false, false, kParameters, "The piston's seals stick and slip.", true};

  PistonFriction(const T* fitted, const Scales& scales, double) noexcept : contact_(contact_of(fitted, scales)) {}

  void on_piston(PistonMoment<T>& now) noexcept {
    const auto step = contact_.over(T(now.velocity), now.period_s);
    const T before = force_;
    force_ = step.keep * force_ + step.give * now.velocity;
    now.force -= force_ + contact_.damping_time() / now.period_s * (force_ - before);
  }

 private:
  DryContact<T> contact_;
  T force_ = T(0.0);
};

}  // namespace farrier::plant
