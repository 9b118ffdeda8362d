#include "control/numerics/riccati.hpp"

#include <cmath>

#include "control/numerics/riccati_problem.hpp"
#include "control/numerics/spectrum.hpp"

namespace farrier::control {
namespace {

using riccati::Columns;
using riccati::gain;
using riccati::has_definite_weights;
using riccati::is_finite;
using riccati::Problem;
using riccati::Square;
using riccati::symmetric_part;
using riccati::weighted;
using riccati::weighted_square;

constexpr int kMaxDoublings = 40;
constexpr int kMaxSmithDoublings = 40;
constexpr int kMaxCorrections = 2;
constexpr double kDoublingTolerance = 1e-9;  // the error of the next step is its square
constexpr double kGoodResidual = 1e-13;      // no correction below this
constexpr double kAcceptedResidual = 1e-8;
constexpr int kRadiusRounds = 8;  // of three squarings each
constexpr double kMarginalRadius = 1.0 - 1e-5;  // nearer to one, the radius is computed from the eigenvalues

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

/// Spectral radius as the limit of ||M^p||^(1/p) at p = 2^24 (Gelfand 1941): to ~1e-6, in a fraction of the time
/// the eigenvalues take. Near one, where the last digits decide, the eigenvalues are computed.
template <int N>
double quick_spectral_radius(const Square<N>& m) noexcept {
  Square<N> power = m;
  double logarithm = 0.0;
  double weight = 1.0;
  for (int i = 0; i < kRadiusRounds; ++i) {
    const double norm = power.norm();
    if (!(norm > 0.0)) {
      return norm;  // nilpotent, or not a number
    }
    logarithm += weight * std::log(norm);
    weight *= 0.125;
    power *= 1.0 / norm;
    const Square<N> second = power * power;
    const Square<N> fourth = second * second;
    power = fourth * fourth;
  }
  const double radius = std::exp(logarithm);
  if (radius < kMarginalRadius) {
    return radius;
  }
  if constexpr (N == Eigen::Dynamic) {
    return any_size::spectral_radius(m);
  } else {
    return spectral_radius(m);
  }
}

/// Names why no stabilising solution was found.
template <int N, int M>
RiccatiStatus name_failure(const Problem<N, M>& p, RiccatiStatus otherwise) noexcept {
  double distance = 0.0;
  if constexpr (N == Eigen::Dynamic) {
    distance = any_size::stabilisability(p.a, p.b);
  } else {
    distance = stabilisability(p.a, p.b);
  }
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

/// Judges S: gain, residual, closed loop.
template <int N, int M>
Result<RiccatiSolution<N, M>, RiccatiStatus> judge(const Problem<N, M>& p, const Square<N>& s, int iterations,
                                                   double relative_residual) noexcept {
  RiccatiSolution<N, M> solution{s, gain<N, M>(p, s), iterations, relative_residual, 0.0};
  solution.spectral_radius = quick_spectral_radius<N>(p.a - p.b * solution.k);
  if (!(solution.relative_residual <= kAcceptedResidual) || std::isnan(solution.spectral_radius)) {
    return name_failure<N, M>(p, RiccatiStatus::kNotConverged);
  }
  if (solution.spectral_radius >= kMarginalRadius) {
    const RiccatiStatus status = name_failure<N, M>(
        p, solution.spectral_radius >= 1.0 ? RiccatiStatus::kClosedLoopUnstable : RiccatiStatus::kSolved);
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

}  // namespace

const char* to_string(RiccatiStatus status) noexcept {
  switch (status) {
    case RiccatiStatus::kSolved: return "solved";
    case RiccatiStatus::kNotFinite: return "not finite";
    case RiccatiStatus::kWeightsNotDefinite: return "weights not definite";
    case RiccatiStatus::kNotStabilisable: return "not stabilisable";
    case RiccatiStatus::kNotConverged: return "not converged";
    case RiccatiStatus::kClosedLoopUnstable: return "closed loop unstable";
  }
  return "unknown";
}

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
  while (!converged && iterations < kMaxDoublings) {
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
    converged = step.norm() <= kDoublingTolerance * size;
  }
  if (!converged) {
    return name_failure<N, M>(p, RiccatiStatus::kNotConverged);
  }
  Square<N> residual = residual_of<N, M>(p, h);
  double relative = relative_norm<N>(residual, h);
  for (int i = 0; i < kMaxCorrections && relative > kGoodResidual; ++i) {
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

template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration(const Square<N>& a, const Columns<N, 1>& b,
                                                                  const Square<N>& q, double r, const Columns<N, 1>& n,
                                                                  int max_iterations,
                                                                  double relative_tolerance) noexcept {
  const Problem<N, 1> p{a, b, q, r, n};
  if (!is_finite<N, 1>(p)) {
    return RiccatiStatus::kNotFinite;
  }
  if (!has_definite_weights<N, 1>(p)) {
    return RiccatiStatus::kWeightsNotDefinite;
  }
  Square<N> s = symmetric_part<N>(q) - n * n.transpose() / r;  // (8.2)
  for (int i = 1; i <= max_iterations; ++i) {
    const Square<N> residual = residual_of<N, 1>(p, s);
    const double relative = relative_norm<N>(residual, s);
    if (!std::isfinite(relative)) {
      break;
    }
    if (relative <= relative_tolerance) {
      return judge<N, 1>(p, s, i, relative);
    }
    s += symmetric_part<N>(residual);  // (8.1)
  }
  return name_failure<N, 1>(p, RiccatiStatus::kNotConverged);
}

#define FARRIER_INSTANTIATE(N, M)                                                                            \
  template Square<N> riccati_residual<N, M>(const Square<N>&, const Columns<N, M>&, const Square<N>&,          \
                                            const InputWeight<M>&, const Columns<N, M>&, const Square<N>&) noexcept; \
  template Result<RiccatiSolution<N, M>, RiccatiStatus> solve_dare<N, M>(                                      \
      const Square<N>&, const Columns<N, M>&, const Square<N>&, const InputWeight<M>&, const Columns<N, M>&) noexcept;
#define FARRIER_INSTANTIATE_ITERATION(N)                                                                       \
  FARRIER_INSTANTIATE(N, 1)                                                                                    \
  template Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration<N>(                               \
      const Square<N>&, const Columns<N, 1>&, const Square<N>&, double, const Columns<N, 1>&, int, double) noexcept;
FARRIER_INSTANTIATE_ITERATION(2)
FARRIER_INSTANTIATE_ITERATION(3)
FARRIER_INSTANTIATE_ITERATION(4)
FARRIER_INSTANTIATE_ITERATION(5)
FARRIER_INSTANTIATE_ITERATION(6)
FARRIER_INSTANTIATE(Eigen::Dynamic, Eigen::Dynamic)
#undef FARRIER_INSTANTIATE_ITERATION
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
