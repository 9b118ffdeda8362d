#pragma once

#include "plant/effects/effect.hpp"
#include "plant/exponential.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

/// Dry friction between the load and its guide, beside the viscous one. All zero but the last two: none.
struct FrictionParams {
  double coulomb = 0.0;             ///< F_c, N or Nm: at speeds well above the Stribeck velocity; > 0, or 0 for none
  double breakaway = 0.0;           ///< F_s, N or Nm: the most that holds at rest; >= coulomb, 0 with it
  double stribeck_velocity = 0.01;  ///< v_s, m/s or rad/s; > 0
  double presliding = 1e-5;         ///< z_s, m or rad: the contact gives F_s / z_s times its deflection; > 0
};

inline Result<Done> validate(const FrictionParams& friction) {
  Refusals refusals("friction");
  refusals.not_negative("coulomb", friction.coulomb);
  refusals.require(friction.breakaway >= friction.coulomb && (friction.coulomb > 0.0 || friction.breakaway == 0.0),
                   "breakaway", friction.breakaway, "finite and >= coulomb, and 0 where that is 0");
  refusals.positive("stribeck_velocity", friction.stribeck_velocity);
  refusals.positive("presliding", friction.presliding);
  return refusals.verdict();
}

/// Coulomb and Stribeck friction that truly sticks: the bristle model of Canudas de Wit, Olsson, Astrom and Lischinsky
/// (1995), (1) to (3). It has no bristle damping, because the viscous friction replaces it. In its force f, which acts
/// on the load as -f, it is
///
///   f' = (F_s / z_s) (v - |v| f / g(v)),   g(v) = F_c + (F_s - F_c) exp(-(v / v_s)^2).
///
/// In steady sliding f = g(v) sign(v), the curve of Hubacher (2014), 9.3.1. Always |f| <= F_s. The friction dissipates
/// f v - d/dt (f^2 z_s / (2 F_s)) = |v| f^2 / g >= 0. Under a steady force below F_s the load comes to rest -z_s ln(1 -
/// F / F_s) from where it was and creeps no further: docs/derivations/friction.md.
class Friction : public Effect<1> {
 public:
  /// `force_scale` of tolerances, `largest_speed` the joint reaches; N, m/s or Nm, rad/s.
  Friction(const FrictionParams& params, double force_scale, double largest_speed) noexcept
      : force_scale_(force_scale), largest_speed_(largest_speed) {
    set(params);
  }

  /// Another guide; the state must be passed through carried_over().
  void set(const FrictionParams& params) noexcept {
    params_ = params;
    stiffness_ = params.breakaway / params.presliding;
    drop_ = params.breakaway - params.coulomb;
    inverse_stribeck_ = 1.0 / params.stribeck_velocity;
  }
  /// The force of a contact that became this one: a guide without friction carries none.
  X carried_over(const X& x) const noexcept {
    const double f = x[0] < params_.breakaway ? x[0] : params_.breakaway;
    return {f > -params_.breakaway ? f : -params_.breakaway};
  }

  bool active() const noexcept { return params_.coulomb > 0.0; }
  double fastest_rate(double mass) const noexcept {
    // In sliding F_s |v| / (z_s F_c); stuck, the load on the contact's stiffness.
    const double sliding = stiffness_ * largest_speed_ / params_.coulomb;
    const double stuck = std::sqrt(stiffness_ / mass);
    return sliding > stuck ? sliding : stuck;
  }
  X scale() const noexcept { return {force_scale_}; }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    now.load_force -= x[0];
    bend(now.velocity, x, dx);
  }

 protected:
  void bend(double v, const X& x, X& dx) const noexcept {
    const double ratio = v * inverse_stribeck_;
    const double g = params_.coulomb + drop_ * exponential_decay(ratio * ratio);
    dx[0] = stiffness_ * (v - std::abs(v) * x[0] / g);
  }

 private:
  FrictionParams params_;
  double force_scale_;
  double largest_speed_;
  double stiffness_ = 0.0;
  double drop_ = 0.0;
  double inverse_stribeck_ = 0.0;
};

/// The same between the piston's seals and the cylinder, left of the load cell, which does not read it.
class SealFriction : public Friction {
 public:
  using Friction::Friction;

  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    now.piston_force -= x[0];
    bend(now.velocity, x, dx);
  }
};

}  // namespace farrier::plant
