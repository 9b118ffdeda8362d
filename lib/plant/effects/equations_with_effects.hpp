#pragma once

#include "plant/effects/effects.hpp"
#include "plant/equations.hpp"

namespace farrier::plant {

/// State of a joint with the states of a set of effects.
template <class Set>
struct EffectState : IntegrationState {
  typename Set::X x;
};

/// Inputs that are held over a step; the valve's opening is not.
struct CommandInput {
  double command_A;       ///< within the valve's limits
  double external_force;  ///< N or Nm
};

/// Inputs that are held over a step with the valve's opening.
struct OpeningInput : HeldInput {
  double command_A;
  double opening_A;  ///< current the valve is open for
};

/// The joint's equations with effects between them. Both outlive this. With OpeningInput the effects leave the valve's
/// opening as it is held.
template <class Set, class HeldOver = CommandInput>
class EquationsWithEffects {
 public:
  using State = EffectState<Set>;
  using Input = HeldOver;

  EquationsWithEffects(const JointEquations& joint, const Set& effects) noexcept : joint_(joint), effects_(effects) {}

  State derivative(const State& s, const Input& input) const noexcept {
    State rate;
    const Instant now = instant(s, input, rate.x);
    static_cast<IntegrationState&>(rate) =
        joint_.balance(s, now.chamber_a_Pa, now.chamber_b_Pa, now.feed, now.load_force + now.piston_force);
    if (now.softness_a > 0.0 || now.softness_b > 0.0 || now.play_slope > 0.0) {
      soften(s, now, rate);
    }
    return rate;
  }
  /// Time until the rates bend where the velocity changes its sign, s, at the present acceleration; no number or
  /// negative for never.
  double time_to_bend_s(const State& s, const State& rate) const noexcept {
    return effects_.bends_at_rest() ? -s.velocity / rate.velocity : -1.0;
  }

  /// The present valve, for the pressures at its ports.
  HeldInput valve(const State& s, const Input& input) const noexcept { return valve(before_valve(s, input), input); }
  const Set& effects() const noexcept { return effects_; }
  double opening_A(const State& s, const Input& input) const noexcept { return before_valve(s, input).opening_A; }
  /// Force of effects on the piston, which the load cell does not read; N or Nm, positive along +position.
  double piston_force(const State& s, const Input& input) const noexcept {
    typename Set::X rates;
    return instant(s, input, rates).piston_force;
  }

 private:
  static double opening(const CommandInput& input) noexcept { return input.command_A; }
  static double opening(const OpeningInput& input) noexcept { return input.opening_A; }

  Instant before_valve(const State& s, const Input& input) const noexcept {
    const double p_a = pressure_of(s.compression_a_Pa);
    const double p_b = pressure_of(s.compression_b_Pa);
    Instant now{.command_A = input.command_A,
                .velocity = s.velocity,
                .chamber_a_Pa = p_a,
                .chamber_b_Pa = p_b,
                .opening_A = opening(input),
                .valve_a_Pa = p_a,
                .valve_b_Pa = p_b,
                .feed = {0.0, 1.0, 0.0, 1.0},
                .load_force = input.external_force,
                .position = s.position};
    effects_.before_valve(now, s.x);
    return now;
  }

  HeldInput open(const Instant& now, const CommandInput&) const noexcept {
    HeldInput held = joint_.hold(now.opening_A, now.load_force);
    held.flow_gain *= now.flow_factor;
    return held;
  }
  HeldInput open(const Instant&, const OpeningInput& input) const noexcept { return input; }
  HeldInput valve(const Instant& now, const Input& input) const noexcept {
    HeldInput held = open(now, input);
    (now.opening_A > 0.0 ? held.port_a_Pa : held.port_b_Pa) -= now.supply_fall_Pa;
    return held;
  }

  /// All that effects change, and the rates of their states.
  Instant instant(const State& s, const Input& input, typename Set::X& rates) const noexcept {
    Instant now = before_valve(s, input);
    now.feed = joint_.valve_flow(now.valve_a_Pa, now.valve_b_Pa, valve(now, input));
    rates = effects_.after_valve(now, s.x);
    return now;
  }

  /// Rates of the pressures with 1/beta_e + softness in place of 1/beta_e, except in a void. If the piston gains w =
  /// slope F_h' on the load: F_h' = F_0' - S w. F_0' is the rate without the gain, S the stiffness of the oil that has
  /// pressure.
  void soften(const State& s, const Instant& now, IntegrationState& rate) const noexcept {
    const ActuatorParams& act = joint_.actuator();
    const ChamberVolumes<double> volume = joint_.volumes(s.position);
    const bool full_a = s.compression_a_Pa > 0.0;
    const bool full_b = s.compression_b_Pa > 0.0;
    const double share_a = full_a ? 1.0 / (1.0 + act.bulk_modulus_Pa * now.softness_a) : 1.0;
    const double share_b = full_b ? 1.0 / (1.0 + act.bulk_modulus_Pa * now.softness_b) : 1.0;
    rate.compression_a_Pa *= share_a;
    rate.compression_b_Pa *= share_b;
    if (!(now.play_slope > 0.0)) {
      return;
    }
    const double by_a = act.area_a * act.bulk_modulus_Pa * share_a / volume.a_m3;  // -dp_a'/dw, dp_b'/dw below
    const double by_b = act.area_b * act.bulk_modulus_Pa * share_b / volume.b_m3;
    const double stiffness = (full_a ? act.area_a * by_a : 0.0) + (full_b ? act.area_b * by_b : 0.0);
    const double force_rate =
        (full_a ? act.area_a * rate.compression_a_Pa : 0.0) - (full_b ? act.area_b * rate.compression_b_Pa : 0.0);
    const double gained = now.play_slope * force_rate / (1.0 + stiffness * now.play_slope);
    rate.compression_a_Pa -= by_a * gained;
    rate.compression_b_Pa += by_b * gained;
  }

  const JointEquations& joint_;
  const Set& effects_;
};

}  // namespace farrier::plant
