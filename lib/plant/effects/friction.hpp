#pragma once

#include "plant/dry_contact.hpp"
#include "plant/effects/effect.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

/// Dry friction between the load and its guide, beside the viscous one. All zero but the last two: none.
struct FrictionParams {
  double coulomb = 0.0;             ///< F_c, N or Nm: at speeds well above the Stribeck velocity; > 0, or 0 for none
  double breakaway = 0.0;           ///< F_s, N or Nm: the most that holds at rest; >= coulomb, 0 with it
  double stribeck_velocity = 0.01;  ///< v_s, m/s or rad/s; > 0
  double presliding = 1e-5;         ///< z_s, m or rad: the contact gives F_s / z_s times its deflection; > 0
  double bristle_damping = 0.0;     ///< sigma_1, Ns/m or Nms/rad; >= 0
};

inline Result<Done> validate(const FrictionParams& friction) {
  Refusals refusals("friction");
  refusals.not_negative("coulomb", friction.coulomb);
  refusals.require(friction.breakaway >= friction.coulomb && (friction.coulomb > 0.0 || friction.breakaway == 0.0),
                   "breakaway", friction.breakaway, "finite and >= coulomb, and 0 where that is 0");
  refusals.positive("stribeck_velocity", friction.stribeck_velocity);
  refusals.positive("presliding", friction.presliding);
  refusals.not_negative("bristle_damping", friction.bristle_damping);
  return refusals.verdict();
}

/// The contact of plant::LoadFriction, integrated: the state is the force of DryContact, which acts on the load as -f.
class Friction : public Effect<1> {
 public:
  /// `force_scale` of tolerances, `largest_speed` the joint reaches; N, m/s or Nm, rad/s.
  Friction(const FrictionParams& params, double force_scale, double largest_speed) noexcept
      : params_(params), contact_(contact_of(params)), force_scale_(force_scale), largest_speed_(largest_speed) {}

  /// Another guide; the state must be passed through carried_over().
  void set(const FrictionParams& params) noexcept {
    params_ = params;
    contact_ = contact_of(params);
  }
  /// The force of a contact that became this one: a guide without friction carries none.
  X carried_over(const X& x) const noexcept {
    const double f = x[0] < params_.breakaway ? x[0] : params_.breakaway;
    return {f > -params_.breakaway ? f : -params_.breakaway};
  }

  bool active() const noexcept { return params_.coulomb > 0.0; }
  double fastest_rate(double mass) const noexcept {
    // In sliding F_s |v| / (z_s F_c); stuck, the load on the contact's stiffness.
    const double sliding = contact_.stiffness() * largest_speed_ / params_.coulomb;
    const double stuck = std::sqrt(contact_.stiffness() / mass);
    return (sliding > stuck ? sliding : stuck) + params_.bristle_damping / mass;
  }
  X scale() const noexcept { return {force_scale_}; }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept { now.load_force -= force(now, x, dx); }

 protected:
  /// Force of bristles and their damping; gives the rate of the state.
  double force(const Instant& now, const X& x, X& dx) const noexcept {
    dx[0] = contact_.rate(x[0], now.velocity);
    return x[0] + contact_.damping_time() * dx[0];
  }

  FrictionParams params_;
  DryContact<double> contact_;

 private:
  static DryContact<double> contact_of(const FrictionParams& params) noexcept {
    return {params.coulomb, params.breakaway, params.stribeck_velocity, params.presliding, params.bristle_damping};
  }

  double force_scale_;
  double largest_speed_;
};

/// The contact of plant::PistonFriction, between the piston's seals and the cylinder, left of the load cell, which does
/// not read it.
class SealFriction : public Friction {
 public:
  using Friction::Friction;

  void after_valve(Instant& now, const X& x, X& dx) const noexcept { now.piston_force -= force(now, x, dx); }
};

}  // namespace farrier::plant
