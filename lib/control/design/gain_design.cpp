#include "control/design/gain_design.hpp"

#include <cmath>

namespace farrier::control {
namespace {

constexpr double kMaxFeedForwardFactor = 2.0;

bool is_positive(double value) noexcept { return value > 0.0 && std::isfinite(value); }

}  // namespace

const char* to_string(DesignStatus status) noexcept {
  switch (status) {
    case DesignStatus::kSuccessful:
      return "successful";
    case DesignStatus::kModelNotFinite:
      return "model not finite";
    case DesignStatus::kWrongSamplingTime:
      return "wrong sampling time";
    case DesignStatus::kNormalisationOutOfBounds:
      return "normalisation out of bounds";
    case DesignStatus::kIntegralFactorOutOfBounds:
      return "integral factor out of bounds";
    case DesignStatus::kWrongOptionForFeedForward:
      return "wrong option for feed-forward";
    case DesignStatus::kDelayOutOfBounds:
      return "delay out of bounds";
    case DesignStatus::kWeightsNotPositiveDefinite:
      return "weights not positive definite";
    case DesignStatus::kNotStabilisable:
      return "not stabilisable";
    case DesignStatus::kNotControllable:
      return "not controllable";
    case DesignStatus::kPolesOutOfBounds:
      return "poles out of bounds";
    case DesignStatus::kPolesNotPlaced:
      return "poles not placed";
    case DesignStatus::kRiccatiNotConverging:
      return "Riccati equation not converging";
    case DesignStatus::kClosedLoopNotStable:
      return "closed loop not stable";
  }
  return "unknown";
}

DiscreteModel normalise(const DiscreteModel& model, const Normalisation& normalisation) noexcept {
  const Eigen::Vector3d t(normalisation.position, normalisation.velocity, normalisation.force);
  return {t.cwiseInverse().asDiagonal() * model.a * t.asDiagonal(),
          t.cwiseInverse().cwiseProduct(model.b) * normalisation.current_A};
}

namespace gain_design {

DesignStatus check(const Problem& problem) noexcept {
  const Normalisation& n = problem.normalisation;
  if (!problem.model.a.allFinite() || !problem.model.b.allFinite()) {
    return DesignStatus::kModelNotFinite;
  }
  if (!is_positive(n.position) || !is_positive(n.velocity) || !is_positive(n.force) || !is_positive(n.current_A)) {
    return DesignStatus::kNormalisationOutOfBounds;
  }
  if (!(problem.feed_forward_factor >= 0.0 && problem.feed_forward_factor <= kMaxFeedForwardFactor)) {
    return DesignStatus::kWrongOptionForFeedForward;
  }
  if (problem.delay_ticks < 0 || problem.delay_ticks > kMaxDelayTicks) {
    return DesignStatus::kDelayOutOfBounds;
  }
  return DesignStatus::kSuccessful;
}

}  // namespace gain_design
}  // namespace farrier::control
