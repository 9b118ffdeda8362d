#include "supervisor/update_record.hpp"

namespace farrier::supervisor {
namespace {

using signals::UpdateVerdict;

// True if a design was refused, not an estimate.
bool is_refusal(UpdateVerdict verdict) noexcept {
  switch (verdict) {
    case UpdateVerdict::kDesignRefused:
    case UpdateVerdict::kUnstableOnEstimate:
    case UpdateVerdict::kUnstableOnStoredModel:
    case UpdateVerdict::kGainsTooLarge:
    case UpdateVerdict::kMarginTooSmall:
    case UpdateVerdict::kDwellTooLong:
      return true;
    case UpdateVerdict::kAccepted:
    case UpdateVerdict::kNotDifferentEnough:
    case UpdateVerdict::kNotConverged:
    case UpdateVerdict::kNotValid:
    case UpdateVerdict::kGainsChangeFast:
    case UpdateVerdict::kErrorTooLarge:
    case UpdateVerdict::kErrorNotWhite:
    case UpdateVerdict::kDwelling:
      break;
  }
  return false;
}

}  // namespace

signals::JointUpdateDecision record_of(const signals::JointModelEstimate& estimate, Tick tick) noexcept {
  signals::JointUpdateDecision decision;
  decision.joint = estimate.joint;
  decision.tick = tick;
  decision.estimate_tick = estimate.tick;
  decision.phase = estimate.phase;
  decision.estimate_samples = estimate.samples;
  decision.validity = estimate.validity;
  decision.excitation = estimate.excitation;
  decision.prediction_error = estimate.prediction_error;
  decision.whiteness = estimate.whiteness;
  decision.model_a = estimate.a;
  decision.model_b = estimate.b;
  return decision;
}

bool UpdateNews::take(UpdateVerdict verdict) noexcept {
  const bool refused = is_refusal(verdict);
  is_news_ = verdict == UpdateVerdict::kAccepted || (refused && verdict != last_);
  if (verdict == UpdateVerdict::kAccepted || refused) {
    last_ = verdict;
  }
  return is_news_;
}

}  // namespace farrier::supervisor
