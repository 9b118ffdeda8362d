#pragma once

#include "control/design/lqr.hpp"
#include "control/design/pole_placement.hpp"

namespace farrier::control {

enum class DesignMethod {
  kLqr,            ///< weights and the Riccati equation
  kPolePlacement,  ///< bandwidth and damping
};

/// Rule by which a joint's gains are found. Pole placement uses only the feed-forward factor of the weights.
struct DesignRule {
  DesignMethod method = DesignMethod::kLqr;
  LqrWeights weights;
  PolePlacement poles;
};

/// Gains for a sampled model by the rule's method. `period_s` is that of `model`. Refuses by name, as the methods do.
/// `poles`, if not null, receives the poles of the loop, as of design_lqr.
Result<Gains, DesignStatus> design(const DiscreteModel& model, const DesignRule& rule,
                                   const Normalisation& normalisation, Form form, int delay_ticks, double period_s,
                                   SmallSpectrum* poles = nullptr) noexcept;

}  // namespace farrier::control
