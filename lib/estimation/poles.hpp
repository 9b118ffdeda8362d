#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>

namespace farrier::estimation {

/// Eigenvalues of a system matrix with N states; N = 2, 3.
template <int N>
using Poles = std::array<std::complex<double>, N>;

/// Eigenvalues of `a`, largest modulus first; of a conjugate pair the one above the real axis first. Computed from the
/// characteristic polynomial of the balanced matrix about the mean of its eigenvalues. The error of each is about eps
/// |a|^N over the product of its distances to the others; for two that coincide, the root of eps. All NaN if `a` is not
/// finite or too large to be cubed.
template <int N>
Poles<N> poles(const Eigen::Matrix<double, N, N>& a) noexcept;

/// Distance of two sets of poles: the least, over all pairings, of the largest |a_i - b_j| of a pair. Infinite if a
/// pole is not finite.
template <int N>
double pole_distance(const Poles<N>& a, const Poles<N>& b) noexcept;

/// First-order standard error of each pole z of an estimated `a` (Stewart and Sun 1990, IV.2.2). The estimate's row r
/// has covariance residual_variance(r) * covariance. With v, w the right and left eigenvectors, it is
///
///     sqrt(sum_r |w_r|^2 residual_variance(r) v^H P v) / |w^H v|.
///
/// This is the root of the expected |dz|^2, real and imaginary part together. `z` is poles(a); `covariance` is the
/// states' block of P. The result is in [0, 1], from exact to as wide as the unit circle. It is 1 where two poles meet,
/// because the first order fails there, and where anything is not finite. `residual_variance` must not be negative.
template <int N>
std::array<double, N> pole_standard_error(const Eigen::Matrix<double, N, N>& a, const Poles<N>& z,
                                          const Eigen::Matrix<double, N, 1>& residual_variance,
                                          const std::array<Eigen::Matrix<double, N, N>, N>& covariance) noexcept;

/// The same where all rows share one covariance.
template <int N>
std::array<double, N> pole_standard_error(const Eigen::Matrix<double, N, N>& a, const Poles<N>& z,
                                          const Eigen::Matrix<double, N, 1>& residual_variance,
                                          const Eigen::Matrix<double, N, N>& covariance) noexcept {
  std::array<Eigen::Matrix<double, N, N>, N> rows;
  rows.fill(covariance);
  return pole_standard_error<N>(a, z, residual_variance, rows);
}

}  // namespace farrier::estimation
