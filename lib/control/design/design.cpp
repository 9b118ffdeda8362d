#include "control/design/design.hpp"

namespace farrier::control {

Result<Gains, DesignStatus> design(const DiscreteModel& model, const DesignRule& rule,
                                   const Normalisation& normalisation, Form form, int delay_ticks, double period_s,
                                   SmallSpectrum* poles) noexcept {
  switch (rule.method) {
    case DesignMethod::kLqr:
      return design_lqr(model, rule.weights, normalisation, form, delay_ticks, poles);
    case DesignMethod::kPolePlacement:
      return design_pole_placement(model, rule.poles, rule.weights.feed_forward_factor, normalisation, form,
                                   delay_ticks, period_s, poles);
  }
  return DesignStatus::kPolesNotPlaced;
}

}  // namespace farrier::control
