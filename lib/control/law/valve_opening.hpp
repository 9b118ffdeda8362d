#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "plant/terms/active_effect.hpp"

namespace farrier::control {

/// Opening of a valve, as the current at which an ideal valve opens as far. It knows the effects plant::ValveBias,
/// ValveDeadband, FlowSaturation and ValveAsymmetry, which act in this order. Models that are linear in the current are
/// estimated from the opening, because the current that EffectCompensation sends jumps across the overlap.
class ValveOpening {
 public:
  ValveOpening() = default;
  explicit ValveOpening(std::span<const plant::ActiveEffect> effects) noexcept {
    using plant::effect_id;
    const auto take = [&](plant::EffectId id, double& value) {
      if (const auto* effect = plant::find(effects, id)) {
        value = effect->values[0];
        active_ = true;
      }
    };
    take(effect_id<plant::ValveBias>(), bias_A_);
    take(effect_id<plant::ValveDeadband>(), overlap_A_);
    take(effect_id<plant::ValveAsymmetry>(), asymmetry_);
    double saturation_A = std::numeric_limits<double>::infinity();
    take(effect_id<plant::FlowSaturation>(), saturation_A);
    inverse_saturation_1_A_ = 1.0 / saturation_A;
  }

  /// `current_A` as it was sent. Without any of these effects the output equals it, bit for bit.
  double at(double current_A) const noexcept {
    if (!active_) {
      return current_A;
    }
    const double spool_A = current_A + bias_A_;
    const double past_overlap_A = std::copysign(std::max(std::abs(spool_A) - overlap_A_, 0.0), spool_A);
    const double share = past_overlap_A * inverse_saturation_1_A_;
    const double ports_A = past_overlap_A / std::sqrt(1.0 + share * share);
    return ports_A * (ports_A > 0.0 ? 1.0 + asymmetry_ : 1.0 - asymmetry_);
  }

 private:
  bool active_ = false;
  double bias_A_ = 0.0;
  double overlap_A_ = 0.0;
  double asymmetry_ = 0.0;
  double inverse_saturation_1_A_ = 0.0;
};

}  // namespace farrier::control
