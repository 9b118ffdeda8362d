#pragma once

#include "plant/effects/effects.hpp"
#include "plant/equations.hpp"

namespace farrier::plant {

/// State of a joint with what its effects add.
struct EffectState : IntegrationState {
  Effects::X x;
};

/// What is held over a step where the valve's opening is not.
struct CommandInput {
  double command_A;       ///< within the valve's limits
  double external_force;  ///< N or Nm
};

/// The joint's equations with its effects between them. Both outlive this.
class EquationsWithEffects {
 public:
  using State = EffectState;
  using Input = CommandInput;

  EquationsWithEffects(const JointEquations& joint, const Effects& effects) noexcept
      : joint_(joint), effects_(effects) {}

  EffectState derivative(const EffectState& s, const CommandInput& input) const noexcept {
    Instant now = before_valve(s, input);
    now.feed = joint_.valve_flow(now.valve_a_Pa, now.valve_b_Pa, joint_.hold(now.opening_A, 0.0));
    EffectState rate;
    rate.x = effects_.after_valve(now, s.x);
    static_cast<IntegrationState&>(rate) =
        joint_.balance(s, now.chamber_a_Pa, now.chamber_b_Pa, now.feed, now.load_force);
    return rate;
  }

  /// The valve as it stands now, for the pressures at its ports.
  HeldInput valve(const EffectState& s, const CommandInput& input) const noexcept {
    return joint_.hold(before_valve(s, input).opening_A, input.external_force);
  }
  double opening_A(const EffectState& s, const CommandInput& input) const noexcept {
    return before_valve(s, input).opening_A;
  }

 private:
  Instant before_valve(const EffectState& s, const CommandInput& input) const noexcept {
    const double p_a = pressure_of(s.compression_a_Pa);
    const double p_b = pressure_of(s.compression_b_Pa);
    Instant now{.command_A = input.command_A,
                .velocity = s.velocity,
                .chamber_a_Pa = p_a,
                .chamber_b_Pa = p_b,
                .opening_A = input.command_A,
                .valve_a_Pa = p_a,
                .valve_b_Pa = p_b,
                .feed = {0.0, 1.0, 0.0, 1.0},
                .load_force = input.external_force};
    effects_.before_valve(now, s.x);
    return now;
  }

  const JointEquations& joint_;
  const Effects& effects_;
};

}  // namespace farrier::plant
