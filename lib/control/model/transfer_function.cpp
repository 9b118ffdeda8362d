#include "control/model/transfer_function.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "control/numerics/balance.hpp"
#include "core/ensure.hpp"
#include "core/units.hpp"

namespace farrier::control {
namespace {

using Complex = std::complex<double>;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kMarkovRoundings = 64.0;

/// The same system in states scaled by powers of two, in which rounding is of like size everywhere. NaN throughout for
/// entries that are not finite.
template <int N>
SingleInOut<N> balanced(const SingleInOut<N>& system) noexcept {
  SingleInOut<N> of = system;
  if (!system.a.allFinite() || !system.b.allFinite() || !system.c.allFinite() || !std::isfinite(system.d)) {
    of.a.setConstant(kNotANumber);
    of.d = kNotANumber;
    return of;
  }
  const Eigen::Matrix<double, N, 1> scale = balance<false>(of.a);
  of.b = scale.cwiseInverse().asDiagonal() * system.b;
  of.c = system.c * scale.asDiagonal();
  return of;
}

Complex point(double frequency_Hz, double period_s) noexcept {
  const double omega = 2.0 * std::numbers::pi * frequency_Hz;
  return period_s > 0.0 ? std::polar(1.0, omega * period_s) : Complex(0.0, omega);
}

template <int N>
Complex response_at(const SingleInOut<N>& system, Complex s) noexcept {
  Eigen::Matrix<Complex, N, N> resolvent = -system.a.template cast<Complex>();
  resolvent.diagonal().array() += s;
  if (!std::isfinite(std::abs(s)) || std::isnan(system.d)) {
    return {kNotANumber, kNotANumber};
  }
  const Eigen::Matrix<Complex, N, 1> x = resolvent.partialPivLu().solve(system.b.template cast<Complex>());
  return (system.c.template cast<Complex>() * x)(0) + system.d;
}

/// Orthonormal columns that span all that is orthogonal to the `degree` independent columns of `across`, by Householder's
/// reflections: the last columns of the orthogonal factor of its QR decomposition.
SmallMatrix orthogonal_complement(SmallMatrix across, Eigen::Index degree) noexcept {
  const Eigen::Index n = across.rows();
  SmallMatrix q(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      q(i, j) = i == j ? 1.0 : 0.0;
    }
  }
  for (Eigen::Index k = 0; k < degree; ++k) {
    SmallColumn v(n);
    double square = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      v(i) = i < k ? 0.0 : across(i, k);
      square += v(i) * v(i);
    }
    v(k) += std::copysign(std::sqrt(square), v(k));
    square = 0.0;
    for (Eigen::Index i = k; i < n; ++i) {
      square += v(i) * v(i);
    }
    for (Eigen::Index j = 0; square > 0.0 && j < n; ++j) {
      double column = 0.0;  // v'across, column j
      double row = 0.0;     // q v, row j
      for (Eigen::Index i = k; i < n; ++i) {
        column += v(i) * across(i, j);
        row += q(j, i) * v(i);
      }
      for (Eigen::Index i = k; i < n; ++i) {
        across(i, j) -= 2.0 / square * column * v(i);
        q(j, i) -= 2.0 / square * row * v(i);
      }
    }
  }
  return q.rightCols(n - degree);
}

void sort(SmallSpectrum& z) noexcept {
  std::sort(z.begin(), z.end(), [](const Complex& x, const Complex& y) {
    return x.real() != y.real() ? x.real() > y.real() : x.imag() > y.imag();
  });
}

SmallSpectrum sorted_eigenvalues(const SmallMatrix& m) noexcept {
  SmallSpectrum z(m.rows());
  if (m.rows() == 1) {
    z(0) = m(0, 0);
  } else if (m.rows() > 1) {
    z = eigenvalues(m);
  }
  if (!z.hasNaN()) {
    sort(z);
  }
  return z;
}

}  // namespace

template <int N>
Complex Rational<N>::at(Complex s) const noexcept {
  Complex top = 0.0;
  Complex bottom = 0.0;
  for (int k = N; k >= 0; --k) {
    top = top * s + numerator[k];
    bottom = bottom * s + denominator[k];
  }
  return top / bottom;
}

template <int N>
Rational<N> transfer_function(const SingleInOut<N>& system) noexcept {
  // adj(s I - a) = sum_k M_k s^(N-k), M_1 = I, M_(k+1) = a M_k + p_(N-k) I, p_(N-k) = -tr(a M_k) / k
  const SingleInOut<N> of = balanced(system);
  Rational<N> quotient;
  quotient.denominator[N] = 1.0;
  Eigen::Matrix<double, N, N> adjoint = Eigen::Matrix<double, N, N>::Identity();
  for (int k = 1; k <= N; ++k) {
    quotient.numerator[N - k] = (of.c * adjoint * of.b)(0);
    adjoint = (of.a * adjoint).eval();
    quotient.denominator[N - k] = -adjoint.trace() / k;
    adjoint.diagonal().array() += quotient.denominator[N - k];
  }
  for (int k = 0; k <= N; ++k) {
    quotient.numerator[k] += of.d * quotient.denominator[k];
  }
  return quotient;
}

template <int N>
Complex response(const SingleInOut<N>& system, double frequency_Hz) noexcept {
  return response_at(balanced(system), point(frequency_Hz, system.period_s));
}

template <int N>
std::vector<Complex> responses(const SingleInOut<N>& system, std::span<const double> frequencies_Hz) {
  const SingleInOut<N> of = balanced(system);
  std::vector<Complex> values;
  values.reserve(frequencies_Hz.size());
  for (const double frequency_Hz : frequencies_Hz) {
    values.push_back(response_at(of, point(frequency_Hz, system.period_s)));
  }
  return values;
}

std::vector<double> logarithmic_grid(double from, double to, int count) {
  FARRIER_ENSURE(from > 0.0 && to > 0.0 && count >= 2, "a logarithmic grid needs two ends above zero and two points");
  std::vector<double> grid(static_cast<std::size_t>(count));
  const double step = std::log(to / from) / (count - 1);
  for (int i = 0; i < count; ++i) {
    grid[static_cast<std::size_t>(i)] = i == count - 1 ? to : from * std::exp(step * i);
  }
  return grid;
}

double decibel(Complex value) noexcept { return 20.0 * std::log10(std::abs(value)); }

std::vector<double> unwrapped_degrees(std::span<const Complex> values) {
  std::vector<double> degrees;
  degrees.reserve(values.size());
  for (const Complex& value : values) {
    double phase = kDegrees * std::arg(value);
    if (!degrees.empty()) {
      phase += 360.0 * std::round((degrees.back() - phase) / 360.0);
    }
    degrees.push_back(phase);
  }
  return degrees;
}

template <int N>
SmallSpectrum poles(const SingleInOut<N>& system) noexcept {
  return sorted_eigenvalues(balanced(system).a);
}

template <int N>
SmallSpectrum zeros(const SingleInOut<N>& system) noexcept {
  using Row = Eigen::Matrix<double, 1, N>;
  const SingleInOut<N> of = balanced(system);
  if (of.d != 0.0) {  // of a NaN too
    return sorted_eigenvalues(of.a - of.b * of.c / of.d);
  }
  // Rows c, c a, ... until one of them meets b; beside each the sum of moduli that its rounding goes with.
  SmallMatrix across = SmallMatrix::Zero(N, N);
  Row row = of.c;
  Row moduli = of.c.cwiseAbs();
  int degree = 0;
  double markov = 0.0;
  while (degree < N) {
    across.col(degree++) = row.normalized().transpose();
    markov = (row * of.b)(0);
    if (!(std::abs(markov) <= kMarkovRoundings * kEpsilon * (moduli * of.b.cwiseAbs())(0))) {
      break;
    }
    markov = 0.0;
    row = (row * of.a).eval();
    moduli = (moduli * of.a.cwiseAbs()).eval();
  }
  if (markov == 0.0 || degree == N) {
    return SmallSpectrum(0);
  }
  // a - b c a^r / (c a^(r-1) b) leaves the kernel of the r rows invariant: its eigenvalues there, orthonormal base.
  const SmallMatrix kept = of.a - of.b * (row * of.a) / markov;
  const SmallMatrix kernel = orthogonal_complement(across, degree);
  return sorted_eigenvalues(kernel.transpose() * kept * kernel);
}

template <int N>
std::optional<Resonance> resonance(const SingleInOut<N>& system, double from_Hz, double to_Hz) {
  constexpr double kGridRatio = 1.005;
  constexpr double kGoldenSection = 0.6180339887498949;
  constexpr double kToleranceRatio = 1e-7;
  FARRIER_ENSURE(from_Hz > 0.0 && to_Hz > from_Hz, "a resonance is sought between two rising frequencies above zero");
  const SingleInOut<N> of = balanced(system);
  const auto modulus = [&](double f) { return std::abs(response_at(of, point(f, system.period_s))); };

  const int count = std::max(3, 1 + static_cast<int>(std::ceil(std::log(to_Hz / from_Hz) / std::log(kGridRatio))));
  const std::vector<double> grid = logarithmic_grid(from_Hz, to_Hz, count);
  std::vector<double> size;
  size.reserve(grid.size());
  for (const double f : grid) {
    size.push_back(modulus(f));
  }
  std::size_t highest = 0;
  for (std::size_t i = 1; i + 1 < grid.size(); ++i) {
    if (size[i] >= size[i - 1] && size[i] > size[i + 1] && (highest == 0 || size[i] > size[highest])) {
      highest = i;
    }
  }
  if (highest == 0) {
    return std::nullopt;
  }
  // Golden section (Kiefer 1953); the bracket shrinks by 0.618 each time, so the loop is bounded.
  double low = grid[highest - 1];
  double high = grid[highest + 1];
  double left = high - kGoldenSection * (high - low);
  double right = low + kGoldenSection * (high - low);
  double at_left = modulus(left);
  double at_right = modulus(right);
  while (high - low > kToleranceRatio * low) {
    if (at_left >= at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - kGoldenSection * (high - low);
      at_left = modulus(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + kGoldenSection * (high - low);
      at_right = modulus(right);
    }
  }
  const double frequency_Hz = 0.5 * (low + high);
  return Resonance{frequency_Hz, modulus(frequency_Hz)};
}

template <int N>
SingleInOut<N> normalise(const SingleInOut<N>& system, const Eigen::Matrix<double, N, 1>& state_divisors,
                         double input_divisor, double output_divisor) noexcept {
  SingleInOut<N> of = system;
  of.a = state_divisors.cwiseInverse().asDiagonal() * system.a * state_divisors.asDiagonal();
  of.b = state_divisors.cwiseInverse().asDiagonal() * system.b * input_divisor;
  of.c = system.c * state_divisors.asDiagonal() / output_divisor;
  of.d = system.d * input_divisor / output_divisor;
  return of;
}

#define FARRIER_INSTANTIATE(N)                                                                            \
  template struct Rational<N>;                                                                            \
  template Rational<N> transfer_function<N>(const SingleInOut<N>&) noexcept;                              \
  template Complex response<N>(const SingleInOut<N>&, double) noexcept;                                   \
  template std::vector<Complex> responses<N>(const SingleInOut<N>&, std::span<const double>);             \
  template SmallSpectrum poles<N>(const SingleInOut<N>&) noexcept;                                        \
  template SmallSpectrum zeros<N>(const SingleInOut<N>&) noexcept;                                        \
  template std::optional<Resonance> resonance<N>(const SingleInOut<N>&, double, double);                  \
  template SingleInOut<N> normalise<N>(const SingleInOut<N>&, const Eigen::Matrix<double, N, 1>&, double, \
                                       double) noexcept;
FARRIER_INSTANTIATE(3)
FARRIER_INSTANTIATE(4)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
