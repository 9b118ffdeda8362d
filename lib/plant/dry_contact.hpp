#pragma once

#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::plant {

/// Bristles in a dry contact, for effects of friction: Canudas de Wit, Olsson, Astrom and Lischinsky (1995), (1) to
/// (3), "LuGre". The force f of the bent bristles acts on the sliding side as -f; their damping sigma_1 adds -sigma_1
/// z', z the way they are bent. Viscous friction is the joint's own. Coulomb friction F_c, breakaway friction F_s,
/// Stribeck velocity v_s and presliding way z_s:
///
///   f = sigma_0 z,   sigma_0 = F_s / z_s,   f' = sigma_0 v (1 - sign(v) f / g(v)),   g(v) = F_c + (F_s - F_c) exp(-(v / v_s)^2).
///
/// In steady sliding f = g(v) sign(v), the curve of Hubacher (2014), 9.3.1. Always |f| <= F_s. The friction dissipates
/// f v - d/dt (f^2 z_s / (2 F_s)) = |v| f^2 / g >= 0. Under a steady force below F_s the load comes to rest -z_s ln(1 -
/// F / F_s) from where it was and creeps no further: docs/derivations/friction.md. Forces are in N or Nm, speeds in m/s
/// or rad/s, ways in m or rad.
template <class T>
class DryContact {
 public:
  /// All > 0, but damping >= 0, and breakaway >= coulomb; or coulomb = breakaway = 0 for a contact that carries nothing.
  DryContact(const T& coulomb, const T& breakaway, const T& stribeck_velocity, const T& presliding,
             const T& damping = T(0.0)) noexcept
      : coulomb_(coulomb),
        stiffness_(breakaway / presliding),
        drop_(breakaway - coulomb),
        inverse_stribeck_(1.0 / stribeck_velocity),
        steepness_(coulomb > 0.0 ? T(stiffness_ / coulomb) : T(0.0)),
        damping_time_(breakaway > 0.0 ? T(damping * presliding / breakaway) : T(0.0)) {}

  /// Steady friction at a speed: Stribeck's curve g.
  T steady(const T& speed) const noexcept {
    using portable::exp;
    const T ratio = speed * inverse_stribeck_;
    const T square = ratio * ratio;
    return square > kPastStribeck ? coulomb_ : T(coulomb_ + drop_ * exp(-square));
  }
  /// f', N/s or Nm/s.
  T rate(const T& force, const T& speed) const noexcept { return rate(force, speed, steady(speed)); }
  /// The same where the steady friction at that speed is `steady`.
  T rate(const T& force, const T& speed, const T& steady) const noexcept {
    const T along = speed < 0.0 ? T(-force) : force;
    return stiffness_ * speed * (1.0 - along / steady);  // 0 to the last bit in steady sliding
  }
  /// Coefficients of a step at constant speed, f+ = keep f + give v: the rest of f, and the gain per speed. With a = s
  /// |v| h / g and s = F_s / z_s it is f e^-a + s h phi(a) v, phi(a) = (1 - e^-a) / a.
  struct Step {
    T keep, give;
  };
  Step over(const T& speed, double step_s) const noexcept { return over(speed, step_s, steady(speed)); }
  /// The same where the steady friction at that speed is `steady`.
  Step over(const T& speed, double step_s, const T& steady) const noexcept {
    using portable::exp;
    using std::abs;
    const T a = stiffness_ * abs(speed) * step_s / steady;
    const T keep = exp(-a);
    const T phi = a > 1e-6 ? T((1.0 - keep) / a) : T(1.0 - 0.5 * a);
    return {keep, stiffness_ * step_s * phi};
  }

  /// `along`, the force along the sliding, after a further `way` >= 0, m or rad, at speeds where the steady friction is
  /// F_c: the equation of f' along the way, F_c + (f - F_c) exp(-sigma_0 way / F_c). F_c > 0.
  T slid(const T& along, const T& way) const noexcept {
    using portable::exp;
    return along == coulomb_ ? along : T(coulomb_ + (along - coulomb_) * exp(-way * steepness_));
  }
  /// Speed from which on the steady friction is F_c but for `rest`: v_s sqrt(ln((F_s - F_c) / rest)); at least v_s.
  T sliding_speed(double rest) const noexcept {
    using portable::log;
    using std::sqrt;
    const T ratio = drop_ / rest;
    return (ratio > 2.72 ? T(sqrt(log(ratio))) : T(1.0)) / inverse_stribeck_;
  }
  /// sigma_0, N/m or Nm/rad.
  const T& stiffness() const noexcept { return stiffness_; }
  /// sigma_1 / sigma_0, s: the bristles' damping is this times f'.
  const T& damping_time() const noexcept { return damping_time_; }

 private:
  /// (v / v_s)^2 from which on exp of its negative, 4e-18, is lost beside F_c: breakaway is 2.5 F_c at most.
  static constexpr double kPastStribeck = 40.0;

  T coulomb_, stiffness_, drop_, inverse_stribeck_, steepness_, damping_time_;
};

}  // namespace farrier::plant
