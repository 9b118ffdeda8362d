#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "control/numerics/spectrum.hpp"

namespace farrier::control {

/// A linear model of N states from one input to one output: dx/dt = a x + b u, or x[k+1] = a x[k] + b u[k] with a
/// period above zero; y = c x + d u. In any units. The functions below exist for N = 3 and 4.
template <int N>
struct SingleInOut {
  Eigen::Matrix<double, N, N> a;
  Eigen::Matrix<double, N, 1> b;
  Eigen::Matrix<double, 1, N> c;
  double d = 0.0;
  double period_s = 0.0;  ///< 0: continuous
};

/// Quotient of polynomials in s or z of degree up to N, coefficients from the constant one up.
template <int N>
struct Rational {
  std::array<double, N + 1> numerator{};
  std::array<double, N + 1> denominator{};

  /// Horner's rule on both; not finite at a pole.
  std::complex<double> at(std::complex<double> s) const noexcept;
};

/// c adj(s I - a) b / det(s I - a) + d, the denominator monic (Faddeev and LeVerrier; Gantmacher 1959, IV.5).
template <int N>
Rational<N> transfer_function(const SingleInOut<N>& system) noexcept;

/// c (s I - a)^-1 b + d at s = 2 pi i f, or at z = exp(2 pi i f T). Not finite at a pole on that line or circle, NaN
/// for entries or frequencies that are not finite.
template <int N>
std::complex<double> response(const SingleInOut<N>& system, double frequency_Hz) noexcept;

template <int N>
std::vector<std::complex<double>> responses(const SingleInOut<N>& system, std::span<const double> frequencies_Hz);

/// `count` >= 2 frequencies from `from` to `to`, both > 0 (checked invariants), each the same multiple of the one
/// before.
std::vector<double> logarithmic_grid(double from, double to, int count);

/// 20 log10 of the modulus.
double decibel(std::complex<double> value) noexcept;

/// Phases in degrees: the first in (-180, 180], each next one within 180 of the one before. True as long as the phase
/// turns by less than that between neighbours.
std::vector<double> unwrapped_degrees(std::span<const std::complex<double>> values);

/// Eigenvalues of `a`, by falling real part, of a pair the upper one first; NaN when they cannot be computed.
template <int N>
SmallSpectrum poles(const SingleInOut<N>& system) noexcept;

/// Transmission zeros, in the order of poles(): the eigenvalues of the motion that keeps y at zero (Isidori 1995, 4.3).
/// There are N - r of them, r the relative degree. For d = 0 they are those of a - b c a^r / (c a^(r-1) b) on the
/// kernel of c, ..., c a^(r-1). A Markov parameter c a^k b within 64 roundings of zero counts as zero. Empty if the
/// output does not depend on the input; NaN if they cannot be computed.
template <int N>
SmallSpectrum zeros(const SingleInOut<N>& system) noexcept;

struct Resonance {
  double frequency_Hz;
  double magnitude;  ///< modulus of the response there
};

/// The highest maximum of the modulus inside (from_Hz, to_Hz), 0 < from_Hz < to_Hz (checked invariant), to 1e-6 of its
/// frequency; empty if the modulus has no maximum inside. Maxima nearer than 1 % in frequency count as one.
template <int N>
std::optional<Resonance> resonance(const SingleInOut<N>& system, double from_Hz, double to_Hz);

/// The system in units of the divisors x = T x^, u = V u^, y = W y^: T^-1 a T, T^-1 b V, W^-1 c T, W^-1 d V (Hubacher
/// 2014, (3.9)-(3.11), (3.52), (3.53)). Divisors > 0.
template <int N>
SingleInOut<N> normalise(const SingleInOut<N>& system, const Eigen::Matrix<double, N, 1>& state_divisors,
                         double input_divisor, double output_divisor) noexcept;

}  // namespace farrier::control
