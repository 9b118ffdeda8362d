#pragma once

// The smallest singular value of [a - z I, b], from which stabilisability is judged. Internal to control.

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <limits>

namespace farrier::control {

// Eigenvalues of a double integrator are only known to the root of the machine precision.
inline constexpr double kUnitCircleMargin = 1e-7;

/// Makes the columns of a matrix orthogonal by one-sided Jacobi rotations (Hestenes 1958; Golub and Van Loan 2013,
/// section 8.6.3). Their norms are then the singular values, each to a few rounding errors of the largest. Sweeps end
/// when no pair of columns is farther from orthogonal than rounding.
template <class Pencil>
void orthogonalise_columns(Pencil& m) noexcept {
  using Complex = std::complex<double>;
  constexpr int kMaxSweeps = 40;
  constexpr double kOrthogonal = 4.0 * std::numeric_limits<double>::epsilon();
  const Eigen::Index rows = m.rows();
  bool rotated = true;
  for (int sweep = 0; rotated && sweep < kMaxSweeps; ++sweep) {
    rotated = false;
    for (Eigen::Index p = 0; p + 1 < m.cols(); ++p) {
      for (Eigen::Index q = p + 1; q < m.cols(); ++q) {
        double pp = 0.0;
        double qq = 0.0;
        Complex pq = 0.0;
        for (Eigen::Index i = 0; i < rows; ++i) {
          pp += std::norm(m(i, p));
          qq += std::norm(m(i, q));
          pq += std::conj(m(i, p)) * m(i, q);
        }
        const double size = std::abs(pq);
        if (!(size > kOrthogonal * std::sqrt(pp * qq))) {
          continue;
        }
        rotated = true;
        // The rotation that makes column p and column q, turned by the phase of their product, orthogonal.
        const double zeta = (qq - pp) / (2.0 * size);
        const double tangent = std::copysign(1.0, zeta) / (std::abs(zeta) + std::sqrt(1.0 + zeta * zeta));
        const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
        const double sine = cosine * tangent;
        const Complex phase = std::conj(pq) / size;
        for (Eigen::Index i = 0; i < rows; ++i) {
          const Complex x = m(i, p);
          const Complex y = phase * m(i, q);
          m(i, p) = cosine * x - sine * y;
          m(i, q) = sine * x + cosine * y;
        }
      }
    }
  }
}

/// Smallest singular value of [a - z I, b].
template <class Pencil, class A, class B>
double smallest_singular_value(const A& a, const B& b, std::complex<double> z) noexcept {
  const Eigen::Index n = a.rows();
  Pencil pencil(n + b.cols(), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      pencil(i, j) = a(j, i) - (i == j ? z : 0.0);
    }
    for (Eigen::Index i = 0; i < b.cols(); ++i) {
      pencil(n + i, j) = b(j, i);
    }
  }
  orthogonalise_columns(pencil);
  double smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index j = 0; j < n; ++j) {
    double square = 0.0;
    for (Eigen::Index i = 0; i < pencil.rows(); ++i) {
      square += std::norm(pencil(i, j));
    }
    smallest = std::min(smallest, std::sqrt(square));
  }
  return smallest;
}

/// The least of it over z = 1 and the modes that do not decay.
template <class Pencil, class A, class B, class Modes>
double smallest_over(const A& a, const B& b, const Modes& modes) noexcept {
  double distance = smallest_singular_value<Pencil>(a, b, 1.0);
  for (Eigen::Index i = 0; i < modes.size(); ++i) {
    const std::complex<double> z = modes(i);
    if (std::abs(z) >= 1.0 - kUnitCircleMargin && z.imag() >= 0.0) {
      distance = std::min(distance, smallest_singular_value<Pencil>(a, b, z));
    }
  }
  return distance;
}

}  // namespace farrier::control
