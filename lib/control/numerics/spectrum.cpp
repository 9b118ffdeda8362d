#include "control/numerics/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/numerics/francis.hpp"
#include "control/numerics/smallest_singular_value.hpp"

namespace farrier::control {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using SmallPencil = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates + 1, kMaxStates>;

// Below this multiple of the threshold the singular values are computed; above it rounding cannot change the answer.
constexpr double kClearly = 2.0;

/// A lower bound of the smallest singular value of [a - z I, b] for real z: 1 / |R^-1| (Frobenius norm), from the QR
/// decomposition of its transpose. Modified Gram-Schmidt gives R with backward stability (Bjorck 1967).
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
    case 1: z = m.col(0).cast<std::complex<double>>(); done = m.allFinite(); break;
    case 2: done = francis<2>(m, z); break;
    case 3: done = francis<3>(m, z); break;
    case 4: done = francis<4>(m, z); break;
    case 5: done = francis<5>(m, z); break;
    case 6: done = francis<6>(m, z); break;
    default: break;
  }
  return done ? z : SmallSpectrum::Constant(m.rows(), kNaN);
}

double largest_modulus(const SmallSpectrum& z) noexcept { return z.hasNaN() ? kNaN : z.cwiseAbs().maxCoeff(); }

double spectral_radius(const SmallMatrix& m) noexcept { return largest_modulus(eigenvalues(m)); }

double stabilisability(const SmallMatrix& a, const SmallColumn& b) noexcept {
  const SmallSpectrum modes = eigenvalues(a);
  if (modes.hasNaN() || !b.allFinite()) {
    return kNaN;
  }
  return smallest_over<SmallPencil>(a, b, modes);
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
