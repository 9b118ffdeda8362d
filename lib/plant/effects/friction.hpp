#pragma once

#include "plant/dry_contact.hpp"
#include "plant/effects/effect.hpp"
#include "plant/terms/friction_wave.hpp"
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
/// A contact that slides well above the Stribeck velocity settles at F_c at once. The rest of its state would fall at
/// F_s |v| / (z_s F_c), too fast for a substep, and is smaller than the error allowed to a substep.
class Friction : public Effect<1> {
 public:
  static constexpr bool kNeutralUnlessActive = true;

  /// `force_scale` of tolerances, `largest_speed` the joint reaches; N, m/s or Nm, rad/s. `tolerance` of a substep.
  Friction(const FrictionParams& params, double force_scale, double largest_speed, double tolerance) noexcept
      : contact_(contact_of(params)),
        force_scale_(kCalm * force_scale),
        largest_speed_(largest_speed),
        negligible_(0.1 * tolerance * force_scale_) {
    set(params);
  }

  /// Another guide; the state must be passed through carried_over().
  void set(const FrictionParams& params) noexcept {
    params_ = params;
    contact_ = contact_of(params);
    active_ = params.coulomb > 0.0;
    sliding_power_ = active_ ? params.coulomb * contact_.sliding_speed(negligible_) : -1.0;
  }
  /// The force of a contact that became this one: a guide without friction carries none.
  X carried_over(const X& x) const noexcept {
    const double f = x[0] < params_.breakaway ? x[0] : params_.breakaway;
    return {f > -params_.breakaway ? f : -params_.breakaway};
  }

  bool active() const noexcept { return active_; }
  double fastest_rate(double mass) const noexcept { return fastest_rate(mass, params_.coulomb); }
  /// True if the contact's force follows from the way alone: it slides where the steady friction is F_c.
  bool slides(double velocity) const noexcept {
    return active_ && params_.bristle_damping == 0.0 && std::abs(velocity) * params_.coulomb > sliding_power_;
  }
  const DryContact<double>& contact() const noexcept { return contact_; }
  X scale() const noexcept { return {force_scale_}; }
  bool bends_at_rest() const noexcept { return active(); }
  void settle(double velocity, X& x, X& dx) const noexcept {
    const double steady = std::copysign(params_.coulomb, velocity);
    if (steady * velocity > sliding_power_ && std::abs(x[0] - steady) <= negligible_) {
      x[0] = steady;
      dx[0] = 0.0;
    }
  }
  void after_valve(Instant& now, const X& x, X& dx) const noexcept { now.load_force -= force(now, x, dx); }

 protected:
  /// Force of bristles and their damping; gives the rate of the state.
  double force(const Instant& now, const X& x, X& dx) const noexcept {
    const bool settled = std::abs(x[0]) == params_.coulomb && x[0] * now.velocity > sliding_power_;
    dx[0] = settled ? 0.0 : contact_.rate(x[0], now.velocity);
    return damped(x, dx);
  }
  /// Force of bristles and their damping at a rate of the state.
  double damped(const X& x, const X& dx) const noexcept {
    return contact_.damping_time() > 0.0 ? x[0] + contact_.damping_time() * dx[0] : x[0];
  }
  /// In sliding F_s |v| / (z_s F_c), with the least F_c there is; stuck, the load on the contact's stiffness.
  double fastest_rate(double mass, double least_coulomb) const noexcept {
    const double sliding = contact_.stiffness() * largest_speed_ / least_coulomb;
    const double stuck = std::sqrt(contact_.stiffness() / mass);
    return (sliding > stuck ? sliding : stuck) + params_.bristle_damping / mass;
  }

  FrictionParams params_;
  DryContact<double> contact_;

 private:
  static DryContact<double> contact_of(const FrictionParams& params) noexcept {
    return {params.coulomb, params.breakaway, params.stribeck_velocity, params.presliding, params.bristle_damping};
  }

  /// An error of the force counts this much less than one of a pressure's push: it dies away as the load moves, before
  /// it has moved the load by as much. With it the RMS error of HyQ's joints against a run at tolerance 1e-12 is 6.9e-7,
  /// and that of the same joints without effects 4.4e-7.
  static constexpr double kCalm = 20.0;

  double force_scale_;
  double largest_speed_;
  double negligible_;
  double sliding_power_ = 0.0;  ///< F_c times the speed from which on the contact settles; negative: at once
  bool active_ = false;
};

/// The contact of plant::PositionDependentFriction. Its steady friction changes on the way, so that it settles at no
/// number.
class WavyFriction : public Friction {
 public:
  static constexpr bool kNeutralUnlessActive = false;

  /// As Friction, with the wave about the mean friction of `params`.
  WavyFriction(const FrictionParams& params, const FrictionWave<double>& wave, double force_scale, double largest_speed,
               double tolerance) noexcept
      : Friction(params, force_scale, largest_speed, tolerance), wave_(wave) {}

  double fastest_rate(double mass) const noexcept {
    return Friction::fastest_rate(mass, (1.0 - wave_.waviness) * params_.coulomb);
  }
  void settle(double, X&, X&) const noexcept {}
  void after_valve(Instant& now, const X& x, X& dx) const noexcept {
    dx[0] = contact_.rate(x[0], now.velocity, wave_.level(now.position) * contact_.steady(now.velocity));
    now.load_force -= damped(x, dx);
  }

 private:
  FrictionWave<double> wave_;
};

/// The contact of plant::PistonFriction in a substep in which it slides one way (Friction::slides): no state, however
/// fast it settles.
class SlidingSeal : public Effect<0> {
 public:
  static constexpr bool kNeutralUnlessActive = true;

  explicit SlidingSeal(const DryContact<double>& contact) noexcept : contact_(contact) {}

  /// A substep begins.
  void start(double position, double velocity, double force) noexcept {
    start_ = position;
    direction_ = velocity < 0.0 ? -1.0 : 1.0;
    along_ = direction_ * force;
  }
  double force(double position) const noexcept {
    return direction_ * contact_.slid(along_, direction_ * (position - start_));
  }
  bool active() const noexcept { return true; }
  void before_valve(Instant& now, const X&) const noexcept { now.piston_force -= force(now.position); }

 private:
  DryContact<double> contact_;
  double start_ = 0.0;
  double direction_ = 1.0;
  double along_ = 0.0;
};

/// The contact of plant::PistonFriction, between the piston's seals and the cylinder, left of the load cell, which does
/// not read it.
class SealFriction : public Friction {
 public:
  using Friction::Friction;

  // Before the valve: the equations of both chambers then stand without a branch between them, in vector lanes.
  void before_valve(Instant& now, const X& x) const noexcept {
    X dx;
    now.piston_force -= force(now, x, dx);
    now.seal_rate = dx[0];
  }
  void after_valve(Instant& now, const X&, X& dx) const noexcept { dx[0] = now.seal_rate; }
};

}  // namespace farrier::plant
