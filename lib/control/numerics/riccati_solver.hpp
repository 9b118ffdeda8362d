#pragma once

// The solver of the Riccati equation as a template. Internal to control: riccati.cpp instantiates it for the sizes that
// designs have, textbook for others.

#include <cmath>

#include "core/portable_math.hpp"
#include "control/numerics/riccati_problem.hpp"
#include "control/numerics/spectrum.hpp"

namespace farrier::control::riccati {

/// Eigenvalues and singular values for matrices of N rows.
template <int N>
struct Analysis {
  static double spectral_radius(const Square<N>& m) noexcept { return control::spectral_radius(m); }
  static double stabilisability(const Square<N>& a, const Eigen::Matrix<double, N, 1>& b) noexcept {
    return control::stabilisability(a, b);
  }
};

inline constexpr int kMaxDoublings = 40;
inline constexpr int kMaxSmithDoublings = 40;
inline constexpr int kMaxCorrections = 2;
inline constexpr double kDoublingTolerance = 1e-9;  // the error of the next step is its square
inline constexpr double kGoodResidual = 1e-13;      // no correction below this
inline constexpr double kAcceptedResidual = 1e-8;
inline constexpr int kRadiusRounds = 8;                // of three squarings each
inline constexpr double kMarginalRadius = 1.0 - 1e-5;  // nearer to one, the radius is computed from the eigenvalues

/// W^-1 [F G] by Gauss and Jordan's elimination with pivoting on the largest of a column. At these sizes several times
/// as fast as a general decomposition. A singular W gives non-finite results.
template <int N>
void solve_pair(const Square<N>& w, const Square<N>& f, const Square<N>& g, Square<N>& wf, Square<N>& wg) noexcept {
  constexpr int kWidth = N == Eigen::Dynamic ? Eigen::Dynamic : 3 * N;
  const Eigen::Index n = w.rows();
  Eigen::Matrix<double, N, kWidth, Eigen::RowMajor> table(n, 3 * n);
  table << w, f, g;
  for (Eigen::Index k = 0; k < n; ++k) {
    Eigen::Index pivot = k;
    for (Eigen::Index i = k + 1; i < n; ++i) {
      pivot = std::abs(table(i, k)) > std::abs(table(pivot, k)) ? i : pivot;
    }
    if (pivot != k) {
      table.row(k).swap(table.row(pivot));
    }
    table.row(k) *= 1.0 / table(k, k);
    for (Eigen::Index i = 0; i < n; ++i) {
      if (i != k) {
        const double factor = table(i, k);
        table.row(i) -= factor * table.row(k);
      }
    }
  }
  wf = table.template middleCols<N>(n, n);
  wg = table.template rightCols<N>(n);
}

/// Not below the spectral radius of M, by ||M^p||^(1/p) at p = 1, 8, 64 ... 2^24 (Gelfand 1941): the first that is below
/// one, in a fraction of the time that the eigenvalues take. Near one, where the last digits decide, the spectral radius
/// by the eigenvalues.
template <int N>
double spectral_radius_bound(const Square<N>& m) noexcept {
  Square<N> power = m;
  double logarithm = 0.0;
  double weight = 1.0;
  for (int i = 0; i < kRadiusRounds; ++i) {
    const double norm = power.norm();
    if (!(norm > 0.0)) {
      return norm;  // nilpotent, or not a number
    }
    logarithm += weight * portable::log(norm);
    if (const double bound = portable::exp(logarithm); bound < kMarginalRadius) {
      return bound;
    }
    weight *= 0.125;
    power *= 1.0 / norm;
    const Square<N> second = power * power;
    const Square<N> fourth = second * second;
    power = fourth * fourth;
  }
  return Analysis<N>::spectral_radius(m);
}

/// Names why no stabilising solution was found.
template <int N, int M>
RiccatiStatus name_failure(const Problem<N, M>& p, RiccatiStatus otherwise) noexcept {
  const double distance = Analysis<N>::stabilisability(p.a, p.b);
  return distance < kStabilisabilityThreshold ? RiccatiStatus::kNotStabilisable : otherwise;
}

/// One Newton step (Hewer 1971): S += sum_j (Ac')^j E Ac^j with E the residual, summed by Smith's doubling.
template <int N, int M>
void correct(const Problem<N, M>& p, const Square<N>& residual, Square<N>& s) noexcept {
  Square<N> power = p.a - p.b * gain<N, M>(p, s);
  Square<N> sum = residual;
  const double enough = 1e-3 * residual.norm();
  for (int i = 0; i < kMaxSmithDoublings; ++i) {
    const Square<N> step = power.transpose() * sum * power;
    sum += step;
    if (!(step.norm() > enough)) {
      break;
    }
    power = (power * power).eval();
  }
  if (sum.allFinite()) {
    s += symmetric_part<N>(sum);
  }
}

/// The solution with its gain and closed loop, or why S is refused.
template <int N, int M>
Result<RiccatiSolution<N, M>, RiccatiStatus> judge(const Problem<N, M>& p, const Square<N>& s, int iterations,
                                                   double relative_residual) noexcept {
  RiccatiSolution<N, M> solution{s, gain<N, M>(p, s), iterations, relative_residual, 0.0};
  solution.radius_bound = spectral_radius_bound<N>(p.a - p.b * solution.k);
  if (!(solution.relative_residual <= kAcceptedResidual) || std::isnan(solution.radius_bound)) {
    return name_failure<N, M>(p, RiccatiStatus::kNotConverged);
  }
  if (solution.radius_bound >= kMarginalRadius) {
    const RiccatiStatus status = name_failure<N, M>(
        p, solution.radius_bound >= 1.0 ? RiccatiStatus::kClosedLoopUnstable : RiccatiStatus::kSolved);
    if (status != RiccatiStatus::kSolved) {
      return status;
    }
  }
  return solution;
}

template <int N>
double relative_norm(const Square<N>& residual, const Square<N>& s) noexcept {
  const double size = s.norm();
  return size > 0.0 ? residual.norm() / size : residual.norm();
}

template <int N, int M>
Square<N> residual_of(const Problem<N, M>& p, const Square<N>& s) noexcept {
  return riccati_residual<N, M>(p.a, p.b, p.q, p.r, p.n, s);
}

}  // namespace farrier::control::riccati

namespace farrier::control {

using riccati::Columns;
using riccati::correct;
using riccati::has_definite_weights;
using riccati::is_finite;
using riccati::judge;
using riccati::name_failure;
using riccati::Problem;
using riccati::relative_norm;
using riccati::residual_of;
using riccati::solve_pair;
using riccati::Square;
using riccati::symmetric_part;
using riccati::weighted;
using riccati::weighted_square;

template <int N, int M>
Square<N> riccati_residual(const Square<N>& a, const Columns<N, M>& b, const Square<N>& q, const InputWeight<M>& r,
                           const Columns<N, M>& n, const Square<N>& s) noexcept {
  const Problem<N, M> p{a, b, q, r, n};
  const Square<N> sa = s * a;
  const Columns<N, M> sb = s * b;
  const Columns<N, M> h = a.transpose() * sb + n;
  return a.transpose() * sa - s - weighted_square<N, M>(h, riccati::total_weight<N, M>(p, sb)) + q;
}

template <int N, int M>
Result<RiccatiSolution<N, M>, RiccatiStatus> solve_dare(const Square<N>& a, const Columns<N, M>& b, const Square<N>& q,
                                                        const InputWeight<M>& r, const Columns<N, M>& n) noexcept {
  const Problem<N, M> p{a, b, q, r, n};
  riccati::ensure_sizes<N, M>(p);
  if (!is_finite<N, M>(p)) {
    return RiccatiStatus::kNotFinite;
  }
  if (!has_definite_weights<N, M>(p)) {
    return RiccatiStatus::kWeightsNotDefinite;
  }
  // Cross weights are absorbed: A - B R^-1 N', Q - N R^-1 N'.
  Square<N> f = a - weighted<N, M>(b, r, n);
  Square<N> g = weighted_square<N, M>(b, r);
  Square<N> h = symmetric_part<N>(q) - weighted_square<N, M>(n, r);
  int iterations = 0;
  bool converged = false;
  while (!converged && iterations < riccati::kMaxDoublings) {
    // W = I + G H;  F+ = F W^-1 F,  G+ = G + F W^-1 G F',  H+ = H + F' H W^-1 F
    Square<N> wf;
    Square<N> wg;
    solve_pair<N>(Square<N>::Identity(a.rows(), a.cols()) + g * h, f, g, wf, wg);
    const Square<N> step = wf.transpose() * (h * f);
    const Square<N> growth = f * wg * f.transpose();
    h += symmetric_part<N>(step);
    g += symmetric_part<N>(growth);
    f = (f * wf).eval();
    ++iterations;
    const double size = h.norm();
    if (!std::isfinite(size)) {
      return name_failure<N, M>(p, RiccatiStatus::kNotConverged);
    }
    converged = step.norm() <= riccati::kDoublingTolerance * size;
  }
  if (!converged) {
    return name_failure<N, M>(p, RiccatiStatus::kNotConverged);
  }
  Square<N> residual = residual_of<N, M>(p, h);
  double relative = relative_norm<N>(residual, h);
  for (int i = 0; i < riccati::kMaxCorrections && relative > riccati::kGoodResidual; ++i) {
    Square<N> corrected = h;
    correct<N>(p, residual, corrected);
    const Square<N> left = residual_of<N, M>(p, corrected);
    if (!(left.norm() < residual.norm())) {
      break;
    }
    h = corrected;
    residual = left;
    relative = relative_norm<N>(residual, h);
  }
  return judge<N, M>(p, h, iterations, relative);
}

}  // namespace farrier::control
