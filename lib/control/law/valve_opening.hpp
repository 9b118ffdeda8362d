#pragma once

#include <span>

#include "plant/effects/stateless_terms.hpp"

namespace farrier::control {

/// Opening of a valve with known effects, as the current at which an ideal valve opens as far, by the plant's own terms.
/// Effects with a state are left out. Models that are linear in the current are estimated from the opening, because the
/// current that EffectCompensation sends jumps across the overlap.
class ValveOpening {
 public:
  ValveOpening() = default;
  /// `effects` and `actuator` pass plant::validate, as those of a robot file do.
  ValveOpening(std::span<const plant::ActiveEffect> effects, const plant::ActuatorParams& actuator) noexcept {
    const plant::Scales scales(actuator, {});
    for (const plant::ActiveEffect& effect : effects) {
      if (effect.info().side == plant::Side::kValveAndOil && plant::is_stateless(effect)) {
        add_to(terms_, effect, scales, 0.0);
      }
    }
    active_ = terms_.hooks().valve > 0;
  }

  /// `current_A` as it was sent. Without an effect on the valve the output equals it, bit for bit.
  double at(double current_A) const noexcept {
    if (!active_) {
      return current_A;
    }
    plant::ValveMoment<double> valve{current_A, 1.0};
    terms_.on_valve(valve);
    return valve.flow_factor * valve.opening_A;
  }

 private:
  mutable plant::TermSet<double> terms_;  ///< mutable: hooks may change a term's state, but these have none
  bool active_ = false;
};

}  // namespace farrier::control
