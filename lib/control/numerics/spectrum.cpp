#include "control/numerics/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/numerics/francis.hpp"

namespace farrier::control {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Eigenvalues of a double integrator are only known to the root of the machine precision.
constexpr double kUnitCircleMargin = 1e-7;

using SmallPencil = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates + 1, kMaxStates>;

/// Of [a - z I, b].
template <class Pencil, class A, class B>
double smallest_singular_value(const A& a, const B& b, std::complex<double> z) {
  const Eigen::Index n = a.rows();
  Pencil pencil(n + b.cols(), n);
  pencil.topRows(n) = a.transpose().template cast<std::complex<double>>();
  pencil.topRows(n).diagonal().array() -= z;
  pencil.bottomRows(b.cols()) = b.transpose().template cast<std::complex<double>>();
  const Eigen::JacobiSVD<Pencil> svd(pencil);
  return svd.singularValues()(n - 1);
}

/// Its least over z = 1 and the modes that do not decay.
template <class Pencil, class A, class B, class Modes>
double smallest_over(const A& a, const B& b, const Modes& modes) {
  double distance = smallest_singular_value<Pencil>(a, b, 1.0);
  for (const std::complex<double>& z : modes) {
    if (std::abs(z) >= 1.0 - kUnitCircleMargin && z.imag() >= 0.0) {
      distance = std::min(distance, smallest_singular_value<Pencil>(a, b, z));
    }
  }
  return distance;
}

Eigen::VectorXcd eigenvalues_of_any_size(const Eigen::MatrixXd& m) {
  if (m.allFinite()) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(m, false);
    if (solver.info() == Eigen::Success) {
      return solver.eigenvalues();
    }
  }
  return Eigen::VectorXcd::Constant(m.rows(), kNaN);
}

// Below this multiple of the threshold the singular values are computed: rounding has no say above it.
constexpr double kClearly = 2.0;

/// A lower bound of the smallest singular value of [a - z I, b] for real z: with the QR decomposition of its
/// transpose, 1 / |R^-1| (Frobenius norm); R as backward stable by modified Gram-Schmidt (Bjorck 1967).
template <int N>
double singular_value_bound(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                            double z) noexcept {
  Eigen::Matrix<double, N + 1, N> q;
  q.template topRows<N>() = a.transpose();
  q.template topRows<N>().diagonal().array() -= z;
  q.row(N) = b.transpose();
  double r[N][N];
  double inverse[N][N];
  double square = 0.0;
  for (int j = 0; j < N; ++j) {
    for (int i = 0; i < j; ++i) {
      r[i][j] = q.col(i).dot(q.col(j));
      q.col(j) -= r[i][j] * q.col(i);
    }
    r[j][j] = q.col(j).norm();
    if (!(r[j][j] > 0.0)) {
      return r[j][j];
    }
    q.col(j) *= 1.0 / r[j][j];
    // Column j of R^-1.
    inverse[j][j] = 1.0 / r[j][j];
    square += inverse[j][j] * inverse[j][j];
    for (int i = j - 1; i >= 0; --i) {
      double sum = 0.0;
      for (int k = i + 1; k <= j; ++k) {
        sum += r[i][k] * inverse[k][j];
      }
      inverse[i][j] = -sum * inverse[i][i];
      square += inverse[i][j] * inverse[i][j];
    }
  }
  return 1.0 / std::sqrt(square);
}

template <int N>
bool francis(const SmallMatrix& m, SmallSpectrum& z) noexcept {
  Eigen::Matrix<std::complex<double>, N, 1> found;
  const bool done = francis_eigenvalues<N>(m, found);
  z = found;
  return done;
}

}  // namespace

SmallSpectrum eigenvalues(const SmallMatrix& m) noexcept {
  SmallSpectrum z;
  bool done = false;
  switch (m.rows()) {
    case 2: done = francis<2>(m, z); break;
    case 3: done = francis<3>(m, z); break;
    case 4: done = francis<4>(m, z); break;
    case 5: done = francis<5>(m, z); break;
    case 6: done = francis<6>(m, z); break;
    default: break;
  }
  if (done) {
    return z;
  }
  if (m.allFinite()) {
    const Eigen::EigenSolver<SmallMatrix> solver(m, false);
    if (solver.info() == Eigen::Success) {
      return solver.eigenvalues();
    }
  }
  return SmallSpectrum::Constant(m.rows(), kNaN);
}

double spectral_radius(const SmallMatrix& m) noexcept {
  const SmallSpectrum z = eigenvalues(m);
  return z.hasNaN() ? kNaN : z.cwiseAbs().maxCoeff();
}

double stabilisability(const SmallMatrix& a, const SmallColumn& b) noexcept {
  const SmallSpectrum modes = eigenvalues(a);
  if (modes.hasNaN() || !b.allFinite()) {
    return kNaN;
  }
  return smallest_over<SmallPencil>(a, b, modes);
}

double any_size::spectral_radius(const Eigen::MatrixXd& m) {
  const Eigen::VectorXcd z = eigenvalues_of_any_size(m);
  return z.hasNaN() ? kNaN : z.cwiseAbs().maxCoeff();
}

double any_size::stabilisability(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::VectorXcd modes = eigenvalues_of_any_size(a);
  return modes.hasNaN() || !b.allFinite() ? kNaN : smallest_over<Eigen::MatrixXcd>(a, b, modes);
}

template <int N>
bool is_stabilisable(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b) noexcept {
  Eigen::Matrix<std::complex<double>, N, 1> modes;
  bool clear = b.allFinite() && francis_eigenvalues<N>(a, modes) &&
               singular_value_bound<N>(a, b, 1.0) >= kClearly * kStabilisabilityThreshold;
  for (int i = 0; clear && i < N; ++i) {
    if (std::norm(modes(i)) >= (1.0 - kUnitCircleMargin) * (1.0 - kUnitCircleMargin) && modes(i) != 1.0) {
      clear = modes(i).imag() == 0.0 &&
              singular_value_bound<N>(a, b, modes(i).real()) >= kClearly * kStabilisabilityThreshold;
    }
  }
  return clear || stabilisability(a, b) >= kStabilisabilityThreshold;
}

#define FARRIER_INSTANTIATE(N)                                         \
  template bool is_stabilisable<N>(const Eigen::Matrix<double, N, N>&, \
                                   const Eigen::Matrix<double, N, 1>&) noexcept;
FARRIER_INSTANTIATE(3)
FARRIER_INSTANTIATE(4)
FARRIER_INSTANTIATE(5)
FARRIER_INSTANTIATE(6)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
