#pragma once

#include "control/design/lqr.hpp"
#include "control/design/pole_placement.hpp"

namespace farrier::control {

enum class DesignMethod {
  kLqr,            ///< weights and the Riccati equation
  kPolePlacement,  ///< bandwidth and damping
};

/// How a joint's gains are found. Of the weights pole placement uses the feed-forward factor alone.
struct DesignRule {
  DesignMethod method = DesignMethod::kLqr;
  LqrWeights weights;
  PolePlacement poles;
};

/// Gains for a sampled model by the rule's method. `period_s` is that of `model`. Refuses by name, as the methods do.
/// `poles`, where not null, gets the poles of the loop, as of design_lqr.
Result<Gains, DesignStatus> design(const DiscreteModel& model, const DesignRule& rule,
                                   const Normalisation& normalisation, Form form, int delay_ticks,
                                   double period_s, SmallSpectrum* poles = nullptr) noexcept;

}  // namespace farrier::control
