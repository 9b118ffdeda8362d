#pragma once

#include <Eigen/Core>

#include <complex>

namespace farrier::control {

/// Square matrix, column and eigenvalues of up to six rows; never on the heap.
inline constexpr int kMaxStates = 6;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxStates, kMaxStates>;
using SmallColumn = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxStates, 1>;
using SmallSpectrum = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 1, 0, kMaxStates, 1>;

/// Eigenvalues of a square matrix of 1 to 6 rows (francis.hpp); NaN throughout when they cannot be computed.
SmallSpectrum eigenvalues(const SmallMatrix& m) noexcept;

/// Largest modulus of eigenvalues; NaN when one of them is.
double largest_modulus(const SmallSpectrum& z) noexcept;

/// largest_modulus(eigenvalues(m)).
double spectral_radius(const SmallMatrix& m) noexcept;

/// Below this a pair counts as not stabilisable. In the normalised units of the thesis the full-state force model
/// gives ~1e-15 without a load spring and ~1e-3 with one of 2e4 N/m, so this refuses springs under ~0.2 N/m.
inline constexpr double kStabilisabilityThreshold = 1e-8;

/// Distance of (a, b) from a pair with an uncontrollable mode that does not decay. It is the smallest singular value of
/// [a - z I, b] over z = 1 and the eigenvalues z of `a` on or outside the unit circle (Popov, Belevitch, Hautus test;
/// Eising 1984). NaN if the eigenvalues cannot be computed.
double stabilisability(const SmallMatrix& a, const SmallColumn& b) noexcept;

/// True if stabilisability(a, b) >= kStabilisabilityThreshold, for N = 3..6 states. Usually decided by a lower bound of
/// the singular values in a fraction of the time. False if the eigenvalues cannot be computed.
template <int N>
bool is_stabilisable(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b) noexcept;

}  // namespace farrier::control
