#pragma once

#include <Eigen/LU>

#include <cmath>
#include <complex>

#include "control/design/closed_loop.hpp"
#include "control/design/lqr.hpp"
#include "control/numerics/complex_math.hpp"
#include "control/numerics/spectrum.hpp"

// Common part of every design of Gains: the augmented loop, sorting of its gain, feed-forward, the last check.
namespace farrier::control::gain_design {

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

struct Problem {
  const DiscreteModel& model;  ///< SI
  const Normalisation& normalisation;
  Form form;
  int delay_ticks;
  double feed_forward_factor;
};

/// Returns kSuccessful, or the name of the defect in the problem.
DesignStatus check(const Problem& problem) noexcept;

/// The plant with P states, the last of them the force, an integrator (7.7) before them and D past inputs, newest
/// first, behind them.
template <int P, int D>
struct Augmented {
  static constexpr int kStates = 1 + P + D;
  Square<kStates> a;
  Column<kStates> b;
};

template <int P, int D>
using GainRow = Eigen::Matrix<double, 1, Augmented<P, D>::kStates>;

template <int P, int D>
Augmented<P, D> augment(const Square<P>& a, const Column<P>& b) noexcept {
  constexpr int N = Augmented<P, D>::kStates;
  Augmented<P, D> loop{Square<N>::Zero(), Column<N>::Zero()};
  loop.a(0, 0) = 1.0;
  loop.a(0, P) = -1.0;  // (7.7): sum[k+1] = sum[k] + (r - F)
  loop.a.template block<P, P>(1, 1) = a;
  if constexpr (D == 0) {
    loop.b.template segment<P>(1) = b;
  } else {
    loop.a.template block<P, 1>(1, N - 1) = b;
    loop.b(1 + P) = 1.0;
    for (int i = 1; i < D; ++i) {
      loop.a(1 + P + i, P + i) = 1.0;
    }
  }
  return loop;
}

/// Finds the gain by `rule` and sorts it into `gains`.
template <int P, int D, class Rule>
DesignStatus solve(const Square<P>& a, const Column<P>& b, const Rule& rule, Gains& gains) noexcept {
  const Augmented<P, D> loop = augment<P, D>(a, b);
  if (!is_stabilisable<1 + P + D>(loop.a, loop.b)) {
    return DesignStatus::kNotStabilisable;
  }
  const Result<GainRow<P, D>, DesignStatus> k = rule(loop);
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

template <int P, class Rule>
DesignStatus solve(const Square<P>& a, const Column<P>& b, int delay_ticks, const Rule& rule, Gains& gains) noexcept {
  switch (delay_ticks) {
    case 0:
      return solve<P, 0>(a, b, rule, gains);
    case 1:
      return solve<P, 1>(a, b, rule, gains);
    default:
      return solve<P, 2>(a, b, rule, gains);
  }
}

/// Real part of the feed-forward that makes the gain from reference to force one, without the integrator, at exp(i
/// angle). From z x = A x + B z^-d u with F = 1 follows the plant's input. The feedback of the other states and of the
/// past inputs is added to it (see design_lqr). A singular balance gives a non-finite value.
template <int P>
double unit_gain_feed_forward(const Square<P>& a, const Column<P>& b, const Column<P>& k, const Gains& gains,
                              double angle) noexcept {
  using Complex = std::complex<double>;
  const Complex back = unit_circle(-angle);  // one period back
  Complex delayed = 1.0;
  for (int i = 0; i < gains.delay_ticks; ++i) {
    delayed *= back;
  }
  Eigen::Matrix<Complex, P + 1, P + 1> balance = Eigen::Matrix<Complex, P + 1, P + 1>::Zero();
  balance.template topLeftCorner<P, P>() = a.template cast<Complex>();
  balance.template topLeftCorner<P, P>().diagonal().array() -= 1.0 / back;
  balance.template topRightCorner<P, 1>() = b.template cast<Complex>() * delayed;
  balance(P, P - 1) = 1.0;
  const Eigen::Matrix<Complex, P + 1, 1> wanted =
      balance.partialPivLu().solve(Eigen::Matrix<Complex, P + 1, 1>::Unit(P));
  Complex feed_forward = (1.0 + gains.delay[0] * back + gains.delay[1] * back * back) * wanted(P);
  for (int i = 0; i < P - 1; ++i) {
    feed_forward += k(i) * wanted(i);
  }
  return feed_forward.real();
}

/// Gains whose row for the augmented, normalised loop is found by `rule`. It is called with an Augmented<P, D> and
/// returns Result<GainRow<P, D>, DesignStatus>. The problem has passed check(). `poles`, if not null, receives those of
/// the loop.
template <class Rule>
Result<Gains, DesignStatus> find_gains(const Problem& problem, double integral_factor, const Rule& rule,
                                       SmallSpectrum* poles) noexcept {
  constexpr double kTrackingAngle = 0.0314;  // rad per period: 5 Hz at 1 kHz
  Gains gains{};
  gains.delay_ticks = problem.delay_ticks;
  gains.form = problem.form;
  gains.integral_factor = integral_factor;
  gains.normalisation = problem.normalisation;
  gains.model = problem.model;
  const DiscreteModel plant = normalise(problem.model, problem.normalisation);
  DesignStatus status;
  double feed_forward;
  if (problem.form == Form::kFullState) {
    status = solve<3>(plant.a, plant.b, problem.delay_ticks, rule, gains);
    feed_forward = unit_gain_feed_forward<3>(plant.a, plant.b,
                                             Eigen::Vector3d(gains.position, gains.velocity, gains.force), gains, 0.0);
  } else {
    const Eigen::Matrix2d a = plant.a.bottomRightCorner<2, 2>();
    const Eigen::Vector2d b = plant.b.tail<2>();
    status = solve<2>(a, b, problem.delay_ticks, rule, gains);
    feed_forward = unit_gain_feed_forward<2>(a, b, Eigen::Vector2d(gains.velocity, gains.force), gains, kTrackingAngle);
  }
  if (status != DesignStatus::kSuccessful) {
    return status;
  }
  gains.feed_forward = problem.feed_forward_factor > 0.0 ? problem.feed_forward_factor * feed_forward : 0.0;
  const SmallSpectrum closed_loop = closed_loop_spectrum(problem.model, gains, problem.delay_ticks);
  if (poles != nullptr) {
    *poles = closed_loop;
  }
  gains.spectral_radius = largest_modulus(closed_loop);
  if (!(gains.spectral_radius < 1.0) || !std::isfinite(gains.feed_forward)) {
    return DesignStatus::kClosedLoopNotStable;
  }
  return gains;
}

}  // namespace farrier::control::gain_design
