#include "control/lqr.hpp"

#include <Eigen/LU>

#include <cmath>
#include <complex>

#include "control/closed_loop.hpp"
#include "control/riccati.hpp"
#include "control/spectrum.hpp"

namespace farrier::control {
namespace {

constexpr double kMaxPeriodS = 0.1;
constexpr double kMaxIntegralFactor = 50.0;
constexpr double kMaxFeedForwardFactor = 2.0;
constexpr double kTrackingAngle = 0.0314;  // rad per period: 5 Hz at 1 kHz

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

bool is_positive(double value) noexcept { return value > 0.0 && std::isfinite(value); }

bool is_weight(double value) noexcept { return value >= 0.0 && std::isfinite(value); }

DesignStatus check(const DiscreteModel& model, const LqrWeights& weights, const Normalisation& normalisation,
                   int delay_ticks) noexcept {
  if (!model.a.allFinite() || !model.b.allFinite()) {
    return DesignStatus::kModelNotFinite;
  }
  if (!is_positive(normalisation.position) || !is_positive(normalisation.velocity) ||
      !is_positive(normalisation.force) || !is_positive(normalisation.current_A)) {
    return DesignStatus::kNormalisationOutOfBounds;
  }
  if (!(weights.integral_factor > 0.0 && weights.integral_factor <= kMaxIntegralFactor)) {
    return DesignStatus::kIntegralFactorOutOfBounds;
  }
  if (!(weights.feed_forward_factor >= 0.0 && weights.feed_forward_factor <= kMaxFeedForwardFactor)) {
    return DesignStatus::kWrongOptionForFeedForward;
  }
  if (delay_ticks < 0 || delay_ticks > kMaxDelayTicks) {
    return DesignStatus::kDelayOutOfBounds;
  }
  if (!is_weight(weights.integral) || !is_weight(weights.position) || !is_weight(weights.velocity) ||
      !is_weight(weights.force) || !is_positive(weights.input)) {
    return DesignStatus::kWeightsNotPositiveDefinite;
  }
  return DesignStatus::kSuccessful;
}

DesignStatus name_of(RiccatiStatus status) noexcept {
  switch (status) {
    case RiccatiStatus::kSolved: return DesignStatus::kSuccessful;
    case RiccatiStatus::kNotFinite: return DesignStatus::kModelNotFinite;
    case RiccatiStatus::kWeightsNotDefinite: return DesignStatus::kWeightsNotPositiveDefinite;
    case RiccatiStatus::kNotStabilisable: return DesignStatus::kNotStabilisable;
    case RiccatiStatus::kNotConverged: return DesignStatus::kRiccatiNotConverging;
    case RiccatiStatus::kClosedLoopUnstable: return DesignStatus::kClosedLoopNotStable;
  }
  return DesignStatus::kRiccatiNotConverging;
}

/// The gain (7.8) of the plant with P states, the last of them the force, an integrator before them and D past
/// inputs, newest first, behind them.
template <int P, int D>
Result<Eigen::Matrix<double, 1, 1 + P + D>, DesignStatus> augmented_gain(const Square<P>& a, const Column<P>& b,
                                                                         const Column<P>& state_weights,
                                                                         const LqrWeights& weights) noexcept {
  constexpr int N = 1 + P + D;
  Square<N> augmented = Square<N>::Zero();
  Column<N> input = Column<N>::Zero();
  augmented(0, 0) = 1.0;
  augmented(0, P) = -1.0;  // (7.7): sum[k+1] = sum[k] + (r - F)
  augmented.template block<P, P>(1, 1) = a;
  if constexpr (D == 0) {
    input.template segment<P>(1) = b;
  } else {
    augmented.template block<P, 1>(1, N - 1) = b;
    input(1 + P) = 1.0;
    for (int i = 1; i < D; ++i) {
      augmented(1 + P + i, P + i) = 1.0;
    }
  }
  if (!is_stabilisable<N>(augmented, input)) {
    return DesignStatus::kNotStabilisable;
  }
  Square<N> q = Square<N>::Zero();
  q(0, 0) = weights.integral;
  q.diagonal().template segment<P>(1) = state_weights;
  const auto solution = solve_dare<N>(augmented, input, q, weights.input, Column<N>::Zero());
  if (!solution) {
    return name_of(solution.error());
  }
  return solution.value().k;
}

/// Solves for the gain and sorts it into `gains`.
template <int P, int D>
DesignStatus solve(const Square<P>& a, const Column<P>& b, const Column<P>& state_weights, const LqrWeights& weights,
                   Gains& gains) noexcept {
  const auto k = augmented_gain<P, D>(a, b, state_weights, weights);
  if (!k) {
    return k.error();
  }
  gains.integral = -k.value()(0);
  gains.position = P == 3 ? k.value()(1) : 0.0;
  gains.velocity = k.value()(P - 1);
  gains.force = k.value()(P);
  for (int i = 0; i < D; ++i) {
    gains.delay[static_cast<std::size_t>(i)] = k.value()(1 + P + i);
  }
  return DesignStatus::kSuccessful;
}

template <int P>
DesignStatus solve(const Square<P>& a, const Column<P>& b, const Column<P>& state_weights, const LqrWeights& weights,
                   int delay_ticks, Gains& gains) noexcept {
  switch (delay_ticks) {
    case 0: return solve<P, 0>(a, b, state_weights, weights, gains);
    case 1: return solve<P, 1>(a, b, state_weights, weights, gains);
    default: return solve<P, 2>(a, b, state_weights, weights, gains);
  }
}

/// Real part of the feed-forward that makes the gain from reference to force one, without the integrator, at
/// exp(i angle): from z x = A x + B z^-d u with F = 1, the input wanted is that of the plant plus what the feedback of
/// the other states and of the past inputs takes away (see design_lqr). A singular balance gives a non-finite value.
template <int P>
double unit_gain_feed_forward(const Square<P>& a, const Column<P>& b, const Column<P>& k, const Gains& gains,
                              double angle) noexcept {
  using Complex = std::complex<double>;
  const Complex back = std::polar(1.0, -angle);  // one period back
  Complex delayed = 1.0;
  for (int i = 0; i < gains.delay_ticks; ++i) {
    delayed *= back;
  }
  Eigen::Matrix<Complex, P + 1, P + 1> balance = Eigen::Matrix<Complex, P + 1, P + 1>::Zero();
  balance.template topLeftCorner<P, P>() = a.template cast<Complex>();
  balance.template topLeftCorner<P, P>().diagonal().array() -= 1.0 / back;
  balance.template topRightCorner<P, 1>() = b.template cast<Complex>() * delayed;
  balance(P, P - 1) = 1.0;
  const Eigen::Matrix<Complex, P + 1, 1> wanted = balance.partialPivLu().solve(
      Eigen::Matrix<Complex, P + 1, 1>::Unit(P));
  Complex feed_forward = (1.0 + gains.delay[0] * back + gains.delay[1] * back * back) * wanted(P);
  for (int i = 0; i < P - 1; ++i) {
    feed_forward += k(i) * wanted(i);
  }
  return feed_forward.real();
}

}  // namespace

const char* to_string(DesignStatus status) noexcept {
  switch (status) {
    case DesignStatus::kSuccessful: return "successful";
    case DesignStatus::kModelNotFinite: return "model not finite";
    case DesignStatus::kWrongSamplingTime: return "wrong sampling time";
    case DesignStatus::kNormalisationOutOfBounds: return "normalisation out of bounds";
    case DesignStatus::kIntegralFactorOutOfBounds: return "integral factor out of bounds";
    case DesignStatus::kWrongOptionForFeedForward: return "wrong option for feed-forward";
    case DesignStatus::kDelayOutOfBounds: return "delay out of bounds";
    case DesignStatus::kWeightsNotPositiveDefinite: return "weights not positive definite";
    case DesignStatus::kNotStabilisable: return "not stabilisable";
    case DesignStatus::kRiccatiNotConverging: return "Riccati equation not converging";
    case DesignStatus::kClosedLoopNotStable: return "closed loop not stable";
  }
  return "unknown";
}

DiscreteModel normalise(const DiscreteModel& model, const Normalisation& normalisation) noexcept {
  const Eigen::Vector3d t(normalisation.position, normalisation.velocity, normalisation.force);
  return {t.cwiseInverse().asDiagonal() * model.a * t.asDiagonal(),
          t.cwiseInverse().cwiseProduct(model.b) * normalisation.current_A};
}

Result<Gains, DesignStatus> design_lqr(const DiscreteModel& model, const LqrWeights& weights,
                                       const Normalisation& normalisation, Form form, int delay_ticks) noexcept {
  DesignStatus status = check(model, weights, normalisation, delay_ticks);
  if (status != DesignStatus::kSuccessful) {
    return status;
  }
  Gains gains{};
  gains.delay_ticks = delay_ticks;
  gains.form = form;
  gains.integral_factor = weights.integral_factor;
  gains.normalisation = normalisation;
  gains.model = model;
  const DiscreteModel plant = normalise(model, normalisation);
  const Eigen::Vector3d state_weights(weights.position, weights.velocity, weights.force);
  if (form == Form::kFullState) {
    status = solve<3>(plant.a, plant.b, state_weights, weights, delay_ticks, gains);
    gains.feed_forward = unit_gain_feed_forward<3>(
        plant.a, plant.b, Eigen::Vector3d(gains.position, gains.velocity, gains.force), gains, 0.0);
  } else {
    const Eigen::Matrix2d a = plant.a.bottomRightCorner<2, 2>();
    const Eigen::Vector2d b = plant.b.tail<2>();
    status = solve<2>(a, b, state_weights.tail<2>(), weights, delay_ticks, gains);
    gains.feed_forward =
        unit_gain_feed_forward<2>(a, b, Eigen::Vector2d(gains.velocity, gains.force), gains, kTrackingAngle);
  }
  gains.feed_forward = weights.feed_forward_factor > 0.0 ? weights.feed_forward_factor * gains.feed_forward : 0.0;
  if (status != DesignStatus::kSuccessful) {
    return status;
  }
  gains.spectral_radius = closed_loop_spectral_radius(model, gains, delay_ticks);
  if (!(gains.spectral_radius < 1.0) || !std::isfinite(gains.feed_forward)) {
    return DesignStatus::kClosedLoopNotStable;
  }
  return gains;
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
