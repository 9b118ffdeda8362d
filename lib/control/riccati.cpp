#include "control/riccati.hpp"

#include <Eigen/Cholesky>

#include <cmath>

#include "control/spectrum.hpp"

namespace farrier::control {
namespace {

constexpr int kMaxDoublings = 40;
constexpr int kMaxSmithDoublings = 40;
constexpr int kMaxCorrections = 2;
constexpr double kDoublingTolerance = 1e-9;  // the error of the next step is its square
constexpr double kGoodResidual = 1e-13;      // no correction below this
constexpr double kAcceptedResidual = 1e-8;
constexpr double kSymmetryTolerance = 1e-12;
constexpr double kDefiniteTolerance = 1e-12;  // of the trace: what rounding may take from a semi-definite weight
constexpr int kRadiusRounds = 8;  // of three squarings each
constexpr double kMarginalRadius = 1.0 - 1e-5;  // nearer to one, the radius is computed from the eigenvalues

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;
template <int N>
using Row = Eigen::Matrix<double, 1, N>;

template <int N>
struct Problem {
  const Square<N>& a;
  const Column<N>& b;
  const Square<N>& q;
  double r;
  const Column<N>& n;
};

template <int N>
bool is_finite(const Problem<N>& p) noexcept {
  return p.a.allFinite() && p.b.allFinite() && p.q.allFinite() && p.n.allFinite() && std::isfinite(p.r);
}

template <int N>
bool has_definite_weights(const Problem<N>& p) noexcept {
  if (!(p.r > 0.0) || (p.q - p.q.transpose()).norm() > kSymmetryTolerance * p.q.norm()) {
    return false;
  }
  Square<N> reduced = p.q - p.n * p.n.transpose() / p.r;
  if (reduced.isZero(0.0)) {
    return true;
  }
  const double trace = reduced.trace();
  reduced.diagonal().array() += kDefiniteTolerance * trace;
  return trace > 0.0 && reduced.llt().info() == Eigen::Success;
}

template <int N>
Square<N> symmetric_part(const Square<N>& m) noexcept {
  return 0.5 * (m + m.transpose());
}

template <int N>
Row<N> gain(const Problem<N>& p, const Square<N>& s) noexcept {
  const Row<N> bs = p.b.transpose() * s;
  return (bs * p.a + p.n.transpose()) / (bs.dot(p.b) + p.r);
}

/// W^-1 [F G] by Gauss and Jordan's elimination with pivoting on the largest of a column. At these sizes several times
/// as fast as a general decomposition. A singular W gives non-finite results.
template <int N>
void solve_pair(const Square<N>& w, const Square<N>& f, const Square<N>& g, Square<N>& wf, Square<N>& wg) noexcept {
  Eigen::Matrix<double, N, 3 * N, Eigen::RowMajor> table;
  table << w, f, g;
  for (int k = 0; k < N; ++k) {
    int pivot = k;
    for (int i = k + 1; i < N; ++i) {
      pivot = std::abs(table(i, k)) > std::abs(table(pivot, k)) ? i : pivot;
    }
    if (pivot != k) {
      table.row(k).swap(table.row(pivot));
    }
    table.row(k) *= 1.0 / table(k, k);
    for (int i = 0; i < N; ++i) {
      if (i != k) {
        const double factor = table(i, k);
        table.row(i) -= factor * table.row(k);
      }
    }
  }
  wf = table.template middleCols<N>(N);
  wg = table.template rightCols<N>();
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
  return radius < kMarginalRadius ? radius : spectral_radius(m);
}

/// Names why no stabilising solution was found.
template <int N>
RiccatiStatus name_failure(const Problem<N>& p, RiccatiStatus otherwise) noexcept {
  return stabilisability(p.a, p.b) < kStabilisabilityThreshold ? RiccatiStatus::kNotStabilisable : otherwise;
}

/// One Newton step (Hewer 1971): S += sum_j (Ac')^j E Ac^j with E the residual, summed by Smith's doubling.
template <int N>
void correct(const Problem<N>& p, const Square<N>& residual, Square<N>& s) noexcept {
  Square<N> power = p.a - p.b * gain<N>(p, s);
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
template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> judge(const Problem<N>& p, const Square<N>& s, int iterations,
                                                double relative_residual) noexcept {
  RiccatiSolution<N> solution{s, gain<N>(p, s), iterations, relative_residual, 0.0};
  solution.spectral_radius = quick_spectral_radius<N>(p.a - p.b * solution.k);
  if (!(solution.relative_residual <= kAcceptedResidual) || std::isnan(solution.spectral_radius)) {
    return name_failure<N>(p, RiccatiStatus::kNotConverged);
  }
  if (solution.spectral_radius >= kMarginalRadius) {
    const RiccatiStatus status = name_failure<N>(
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

template <int N>
Square<N> residual_of(const Problem<N>& p, const Square<N>& s) noexcept {
  return riccati_residual<N>(p.a, p.b, p.q, p.r, p.n, s);
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

template <int N>
Square<N> riccati_residual(const Square<N>& a, const Column<N>& b, const Square<N>& q, double r, const Column<N>& n,
                           const Square<N>& s) noexcept {
  const Square<N> sa = s * a;
  const Column<N> sb = s * b;
  const Column<N> h = a.transpose() * sb + n;
  return a.transpose() * sa - s - h * h.transpose() / (b.dot(sb) + r) + q;
}

template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare(const Square<N>& a, const Column<N>& b, const Square<N>& q,
                                                     double r, const Column<N>& n) noexcept {
  const Problem<N> p{a, b, q, r, n};
  if (!is_finite<N>(p)) {
    return RiccatiStatus::kNotFinite;
  }
  if (!has_definite_weights<N>(p)) {
    return RiccatiStatus::kWeightsNotDefinite;
  }
  // Cross weights are absorbed: A - B R^-1 N', Q - N R^-1 N'.
  Square<N> f = a - b * n.transpose() / r;
  Square<N> g = b * b.transpose() / r;
  Square<N> h = symmetric_part<N>(q) - n * n.transpose() / r;
  int iterations = 0;
  bool converged = false;
  while (!converged && iterations < kMaxDoublings) {
    // W = I + G H;  F+ = F W^-1 F,  G+ = G + F W^-1 G F',  H+ = H + F' H W^-1 F
    Square<N> wf;
    Square<N> wg;
    solve_pair<N>(Square<N>::Identity() + g * h, f, g, wf, wg);
    const Square<N> step = wf.transpose() * (h * f);
    const Square<N> growth = f * wg * f.transpose();
    h += symmetric_part<N>(step);
    g += symmetric_part<N>(growth);
    f = (f * wf).eval();
    ++iterations;
    const double size = h.norm();
    if (!std::isfinite(size)) {
      return name_failure<N>(p, RiccatiStatus::kNotConverged);
    }
    converged = step.norm() <= kDoublingTolerance * size;
  }
  if (!converged) {
    return name_failure<N>(p, RiccatiStatus::kNotConverged);
  }
  Square<N> residual = residual_of<N>(p, h);
  double relative = relative_norm<N>(residual, h);
  for (int i = 0; i < kMaxCorrections && relative > kGoodResidual; ++i) {
    Square<N> corrected = h;
    correct<N>(p, residual, corrected);
    const Square<N> left = residual_of<N>(p, corrected);
    if (!(left.norm() < residual.norm())) {
      break;
    }
    h = corrected;
    residual = left;
    relative = relative_norm<N>(residual, h);
  }
  return judge<N>(p, h, iterations, relative);
}

template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration(const Square<N>& a, const Column<N>& b,
                                                                  const Square<N>& q, double r, const Column<N>& n,
                                                                  int max_iterations,
                                                                  double relative_tolerance) noexcept {
  const Problem<N> p{a, b, q, r, n};
  if (!is_finite<N>(p)) {
    return RiccatiStatus::kNotFinite;
  }
  if (!has_definite_weights<N>(p)) {
    return RiccatiStatus::kWeightsNotDefinite;
  }
  Square<N> s = symmetric_part<N>(q) - n * n.transpose() / r;  // (8.2)
  for (int i = 1; i <= max_iterations; ++i) {
    const Square<N> residual = residual_of<N>(p, s);
    const double relative = relative_norm<N>(residual, s);
    if (!std::isfinite(relative)) {
      break;
    }
    if (relative <= relative_tolerance) {
      return judge<N>(p, s, i, relative);
    }
    s += symmetric_part<N>(residual);  // (8.1)
  }
  return name_failure<N>(p, RiccatiStatus::kNotConverged);
}

#define FARRIER_INSTANTIATE(N)                                                                             \
  template Square<N> riccati_residual<N>(const Square<N>&, const Column<N>&, const Square<N>&, double,     \
                                         const Column<N>&, const Square<N>&) noexcept;                     \
  template Result<RiccatiSolution<N>, RiccatiStatus> solve_dare<N>(                                        \
      const Square<N>&, const Column<N>&, const Square<N>&, double, const Column<N>&) noexcept;            \
  template Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration<N>(                           \
      const Square<N>&, const Column<N>&, const Square<N>&, double, const Column<N>&, int, double) noexcept;
FARRIER_INSTANTIATE(2)
FARRIER_INSTANTIATE(3)
FARRIER_INSTANTIATE(4)
FARRIER_INSTANTIATE(5)
FARRIER_INSTANTIATE(6)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
