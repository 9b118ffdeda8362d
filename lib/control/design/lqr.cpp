#include "control/design/lqr.hpp"

#include <cmath>

#include "control/design/gain_design.hpp"
#include "control/numerics/riccati.hpp"

namespace farrier::control {
namespace {

using namespace gain_design;

constexpr double kMaxIntegralFactor = 50.0;

bool is_weight(double value) noexcept { return value >= 0.0 && std::isfinite(value); }

DesignStatus check(const LqrWeights& weights) noexcept {
  if (!(weights.integral_factor > 0.0 && weights.integral_factor <= kMaxIntegralFactor)) {
    return DesignStatus::kIntegralFactorOutOfBounds;
  }
  if (!is_weight(weights.integral) || !is_weight(weights.position) || !is_weight(weights.velocity) ||
      !is_weight(weights.force) || !(weights.input > 0.0 && std::isfinite(weights.input))) {
    return DesignStatus::kWeightsNotPositiveDefinite;
  }
  return DesignStatus::kSuccessful;
}

DesignStatus name_of(RiccatiStatus status) noexcept {
  switch (status) {
    case RiccatiStatus::kSolved:
      return DesignStatus::kSuccessful;
    case RiccatiStatus::kNotFinite:
      return DesignStatus::kModelNotFinite;
    case RiccatiStatus::kWeightsNotDefinite:
      return DesignStatus::kWeightsNotPositiveDefinite;
    case RiccatiStatus::kNotStabilisable:
      return DesignStatus::kNotStabilisable;
    case RiccatiStatus::kNotConverged:
      return DesignStatus::kRiccatiNotConverging;
    case RiccatiStatus::kClosedLoopUnstable:
      return DesignStatus::kClosedLoopNotStable;
  }
  return DesignStatus::kRiccatiNotConverging;
}

/// The weighting of (7.9)-(7.11) and the Riccati equation for it.
struct RiccatiRule {
  const LqrWeights& weights;

  template <int P, int D>
  Result<GainRow<P, D>, DesignStatus> operator()(const Augmented<P, D>& loop) const noexcept {
    constexpr int N = Augmented<P, D>::kStates;
    Square<N> q = Square<N>::Zero();
    q(0, 0) = weights.integral;
    q.diagonal().template segment<P>(1) =
        Eigen::Vector3d(weights.position, weights.velocity, weights.force).template tail<P>();
    const auto solution = solve_dare<N>(loop.a, loop.b, q, weights.input, Column<N>::Zero());
    if (!solution) {
      return name_of(solution.error());
    }
    return solution.value().k;
  }
};

}  // namespace

Result<Gains, DesignStatus> design_lqr(const DiscreteModel& model, const LqrWeights& weights,
                                       const Normalisation& normalisation, Form form, int delay_ticks,
                                       SmallSpectrum* poles) noexcept {
  const Problem problem{model, normalisation, form, delay_ticks, weights.feed_forward_factor};
  DesignStatus status = gain_design::check(problem);
  if (status == DesignStatus::kSuccessful) {
    status = check(weights);
  }
  if (status != DesignStatus::kSuccessful) {
    return status;
  }
  return find_gains(problem, weights.integral_factor, RiccatiRule{weights}, poles);
}

Result<Gains, DesignStatus> design_lqr(const Eigen::Matrix3d& a, const Eigen::Vector3d& b, double period_s,
                                       const LqrWeights& weights, const Normalisation& normalisation, Form form,
                                       int delay_ticks) noexcept {
  if (!(period_s > 0.0 && period_s <= kMaxPeriodS)) {
    return DesignStatus::kWrongSamplingTime;
  }
  return design_lqr(discretise(a, b, period_s), weights, normalisation, form, delay_ticks);
}

}  // namespace farrier::control
