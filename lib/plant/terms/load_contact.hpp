#pragma once

#include "plant/terms/contact_parameters.hpp"
#include "plant/terms/term.hpp"

namespace farrier::plant {

/// A dry contact of the load over substeps: the force of its bristles, and the hooks that effects of friction share.
template <class T>
class LoadContact {
 public:
  /// `fitted` are numbers of kContactParameters, `step_s` the length of a substep.
  LoadContact(const T* fitted, const Scales& scales, double step_s) noexcept
      : contact_(contact_of(fitted, scales)), step_s_(step_s) {}

  void on_load(LoadMoment<T>& now) noexcept { act(now, contact_.over(now.velocity, step_s_)); }
  /// The same where the steady friction is `level` times as large.
  void on_load(LoadMoment<T>& now, const T& level) noexcept {
    act(now, contact_.over(now.velocity, step_s_, T(level * contact_.steady(now.velocity))));
  }
  void after_load(const T& mean_velocity) noexcept { force_ = step_.keep * force_ + step_.give * mean_velocity; }

 private:
  // The mean of the contact's force over the step: half of what it was and half of what it will be.
  void act(LoadMoment<T>& now, const typename DryContact<T>::Step& step) noexcept {
    step_ = step;
    const T damped = contact_.damping_time() / step_s_;  // share of the force's change
    now.hold += (0.5 * (1.0 + step_.keep) + damped * (step_.keep - 1.0)) * force_;
    now.slope += (0.5 + damped) * step_.give;
  }

  DryContact<T> contact_;
  double step_s_;
  typename DryContact<T>::Step step_{};
  T force_ = T(0.0);
};

}  // namespace farrier::plant
