#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace farrier::control {

/// Eigenvalues of a symmetric matrix, rising, and its eigenvectors, a column each and of length one.
template <int N>
struct SymmetricEigen {
  Eigen::Matrix<double, N, 1> values;
  Eigen::Matrix<double, N, N> vectors;
  bool converged;  ///< false: nothing else is of use
};

/// By cyclic Jacobi rotations (Jacobi 1846; Golub and Van Loan 2013, section 8.5): each value to a few rounding errors of
/// the norm, convergence is quadratic. Reads the whole matrix. Does not converge when an entry is not finite.
template <int N>
SymmetricEigen<N> symmetric_eigen(Eigen::Matrix<double, N, N> m) noexcept {
  constexpr int kMaxSweeps = 30;
  constexpr double kRounding = std::numeric_limits<double>::epsilon();
  SymmetricEigen<N> found;
  found.vectors.setIdentity();
  found.converged = false;
  for (int sweep = 0; sweep < kMaxSweeps && !found.converged; ++sweep) {
    double off = 0.0;
    double all = 0.0;
    for (int j = 0; j < N; ++j) {
      for (int i = 0; i < j; ++i) {
        off += m(i, j) * m(i, j);
      }
      all += m(j, j) * m(j, j);
    }
    found.converged = off <= kRounding * kRounding * all;
    for (int p = 0; p + 1 < N && !found.converged; ++p) {
      for (int q = p + 1; q < N; ++q) {
        if (m(p, q) == 0.0) {
          continue;
        }
        const double zeta = (m(q, q) - m(p, p)) / (2.0 * m(p, q));
        const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
        const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
        const double sine = cosine * tangent;
        const auto rotate = [cosine, sine](double& x, double& y) {
          const double turned = cosine * x - sine * y;
          y = sine * x + cosine * y;
          x = turned;
        };
        for (int k = 0; k < N; ++k) {
          rotate(m(k, p), m(k, q));
        }
        for (int k = 0; k < N; ++k) {
          rotate(m(p, k), m(q, k));
          rotate(found.vectors(k, p), found.vectors(k, q));
        }
        m(p, q) = 0.0;
        m(q, p) = 0.0;
      }
    }
  }
  for (int i = 0; i < N; ++i) {
    found.values(i) = m(i, i);
  }
  for (int i = 0; i + 1 < N; ++i) {
    int least = i;
    for (int j = i + 1; j < N; ++j) {
      least = found.values(j) < found.values(least) ? j : least;
    }
    if (least != i) {
      std::swap(found.values(i), found.values(least));
      for (int k = 0; k < N; ++k) {
        std::swap(found.vectors(k, i), found.vectors(k, least));
      }
    }
  }
  return found;
}

}  // namespace farrier::control
