#include "estimation/poles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/portable_math.hpp"

namespace farrier::estimation {
namespace {

using Complex = std::complex<double>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargestEntry = 1e90;  // its cube is finite

// Similarity by powers of two until rows and columns off the diagonal weigh alike (Osborne 1960; Parlett and Reinsch
// 1969). Within a factor of 16 they stay as they are; matrices of normalised states do.
template <int N>
Eigen::Matrix<double, N, N> balanced(Eigen::Matrix<double, N, N> a) noexcept {
  constexpr int kMaxSweeps = 8;
  constexpr double kAlike = 16.0;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    bool changed = false;
    for (int i = 0; i < N; ++i) {
      double row = 0.0;
      double column = 0.0;
      for (int j = 0; j < N; ++j) {
        if (j != i) {
          row += std::abs(a(i, j));
          column += std::abs(a(j, i));
        }
      }
      if (row > 0.0 && column > 0.0 && (row > kAlike * column || column > kAlike * row)) {
        const int exponent = portable::nearest_exponent(std::sqrt(row) / std::sqrt(column));
        const double down = std::ldexp(1.0, -exponent);
        a.row(i) *= down;
        a.col(i) /= down;
        changed = true;
      }
    }
    if (!changed) {
      break;
    }
  }
  return a;
}

// Roots of t^2 + b t + c about a centre.
std::pair<Complex, Complex> quadratic(double centre, double b, double c) noexcept {
  const double quarter = 0.25 * b * b - c;
  if (quarter < 0.0) {
    const double imaginary = std::sqrt(-quarter);
    return {{centre - 0.5 * b, imaginary}, {centre - 0.5 * b, -imaginary}};
  }
  const double larger = -0.5 * b - std::copysign(std::sqrt(quarter), b);
  const double smaller = larger != 0.0 ? c / larger : 0.0;
  return {centre + larger, centre + smaller};
}

// The real root of t^3 + p t + q of largest modulus; its sign is that of -q. Newton's method from beyond it moves
// towards it only, and it is never the double root.
double real_root(double p, double q) noexcept {
  constexpr int kMaxIterations = 64;
  double t = -std::copysign(std::sqrt(std::max(-p, 0.0)) + std::cbrt(std::abs(q)), q);
  for (int i = 0; i < kMaxIterations && t != 0.0; ++i) {
    const double next = t - ((t * t + p) * t + q) / (3.0 * t * t + p);
    if (!(std::abs(next) < std::abs(t))) {
      return t;
    }
    const bool settled = std::abs(t - next) <= std::numeric_limits<double>::epsilon() * std::abs(t);
    t = next;
    if (settled) {
      return t;
    }
  }
  return t == 0.0 ? 0.0 : kNaN;
}

double determinant(const Eigen::Matrix3d& b) noexcept {
  return b(0, 0) * (b(1, 1) * b(2, 2) - b(1, 2) * b(2, 1)) - b(0, 1) * (b(1, 0) * b(2, 2) - b(1, 2) * b(2, 0)) +
         b(0, 2) * (b(1, 0) * b(2, 1) - b(1, 1) * b(2, 0));
}

Poles<2> solve(const Eigen::Matrix2d& a) noexcept {
  // t^2 - ((a11 - a22)/2)^2 - a12 a21 about the mean of the eigenvalues
  const double half = 0.5 * (a(0, 0) - a(1, 1));
  const auto [first, second] = quadratic(0.5 * (a(0, 0) + a(1, 1)), 0.0, -(half * half + a(0, 1) * a(1, 0)));
  return {first, second};
}

Poles<3> solve(Eigen::Matrix3d b) noexcept {
  // det(t I - B) = t^3 + p t + q for B = A - tr(A)/3 I: p = -tr(B^2)/2, q = -det(B)
  const double centre = b.trace() / 3.0;
  b.diagonal().array() -= centre;
  const double p = -0.5 * (b(0, 0) * b(0, 0) + b(1, 1) * b(1, 1) + b(2, 2) * b(2, 2)) - b(0, 1) * b(1, 0) -
                   b(0, 2) * b(2, 0) - b(1, 2) * b(2, 1);
  const double q = -determinant(b);
  const double t = real_root(p, q);
  // t^3 + p t + q = (s - t)(s^2 + t s + t^2 + p) in s
  const auto [second, third] = quadratic(centre, t, t * t + p);
  return {Complex(centre + t), second, third};
}

template <int N>
struct ComplexMatrix {
  Eigen::Matrix<double, N, N> real;
  Eigen::Matrix<double, N, N> imaginary;
};

// adj(z I - B) as a polynomial in z: z I + B - tr(B) I.
ComplexMatrix<2> adjugate(const Eigen::Matrix2d& b, Complex z) noexcept {
  Eigen::Matrix2d real = b;
  real.diagonal().array() += z.real() - b.trace();
  return {real, z.imag() * Eigen::Matrix2d::Identity()};
}

// z^2 I + z (B - tr(B) I) + adj(B).
ComplexMatrix<3> adjugate(const Eigen::Matrix3d& b, Complex z) noexcept {
  Eigen::Matrix3d constant;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int r = (j + 1) % 3, s = (j + 2) % 3, k = (i + 1) % 3, l = (i + 2) % 3;
      constant(i, j) = b(r, k) * b(s, l) - b(r, l) * b(s, k);
    }
  }
  Eigen::Matrix3d linear = b;
  linear.diagonal().array() -= b.trace();
  const double x = z.real();
  const double y = z.imag();
  ComplexMatrix<3> adj{constant + x * linear, y * linear};
  adj.real.diagonal().array() += (x - y) * (x + y);
  adj.imaginary.diagonal().array() += 2.0 * x * y;
  return adj;
}

}  // namespace

template <int N>
Poles<N> poles(const Eigen::Matrix<double, N, N>& a) noexcept {
  Poles<N> z;
  if (!(a.cwiseAbs().sum() <= kLargestEntry)) {
    z.fill({kNaN, kNaN});
    return z;
  }
  z = solve(balanced<N>(a));
  if (std::isnan(z[0].real())) {
    z.fill({kNaN, kNaN});
    return z;
  }
  const auto before = [](const Complex& left, const Complex& right) { return std::norm(left) > std::norm(right); };
  if (before(z[N - 1], z[0])) {
    std::rotate(z.begin(), z.begin() + 1, z.end());
  }
  for (int i = 0; i + 1 < N; ++i) {
    if (before(z[i + 1], z[i])) {
      std::swap(z[i], z[i + 1]);
    }
  }
  return z;
}

template <int N>
double pole_distance(const Poles<N>& a, const Poles<N>& b) noexcept {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::array<int, N> pairing;
  for (int i = 0; i < N; ++i) {
    pairing[i] = i;
    if (!(std::isfinite(std::norm(a[i])) && std::isfinite(std::norm(b[i])))) {
      return kInfinite;
    }
  }
  double least = kInfinite;
  do {
    double largest = 0.0;
    for (int i = 0; i < N; ++i) {
      largest = std::max(largest, std::norm(a[i] - b[pairing[i]]));
    }
    least = std::min(least, largest);
  } while (std::next_permutation(pairing.begin(), pairing.end()));
  return std::sqrt(least);
}

// With G = v w^H / (w^H v) = adj(z I - A) / tr adj(z I - A): dz = tr(G dA). The error of row r of A enters through
// column r of G. Its share is residual_variance(r) g_r^H P g_r.
template <int N>
std::array<double, N> pole_standard_error(const Eigen::Matrix<double, N, N>& a, const Poles<N>& z,
                                          const Eigen::Matrix<double, N, 1>& residual_variance,
                                          const std::array<Eigen::Matrix<double, N, N>, N>& covariance) noexcept {
  std::array<double, N> errors;
  const double centre = a.trace() / N;
  Eigen::Matrix<double, N, N> b = a;
  b.diagonal().array() -= centre;
  for (int i = 0; i < N; ++i) {
    if (i > 0 && z[i] == std::conj(z[i - 1])) {
      errors[i] = errors[i - 1];
      continue;
    }
    const ComplexMatrix<N> adj = adjugate(b, z[i] - centre);
    const double real = adj.real.trace();
    const double imaginary = adj.imaginary.trace();
    double sum = 0.0;
    for (int r = 0; r < N; ++r) {
      const Eigen::Matrix<double, N, 1> x = adj.real.col(r);
      const Eigen::Matrix<double, N, 1> y = adj.imaginary.col(r);
      sum += residual_variance(r) * (x.dot(covariance[r] * x) + y.dot(covariance[r] * y));
    }
    const double variance = sum / (real * real + imaginary * imaginary);
    errors[i] = variance >= 0.0 && variance < 1.0 ? std::sqrt(variance) : 1.0;
  }
  return errors;
}

template Poles<2> poles<2>(const Eigen::Matrix<double, 2, 2>&) noexcept;
template Poles<3> poles<3>(const Eigen::Matrix<double, 3, 3>&) noexcept;
template double pole_distance<2>(const Poles<2>&, const Poles<2>&) noexcept;
template double pole_distance<3>(const Poles<3>&, const Poles<3>&) noexcept;
template std::array<double, 2> pole_standard_error<2>(const Eigen::Matrix<double, 2, 2>&, const Poles<2>&,
                                                      const Eigen::Matrix<double, 2, 1>&,
                                                      const std::array<Eigen::Matrix<double, 2, 2>, 2>&) noexcept;
template std::array<double, 3> pole_standard_error<3>(const Eigen::Matrix<double, 3, 3>&, const Poles<3>&,
                                                      const Eigen::Matrix<double, 3, 1>&,
                                                      const std::array<Eigen::Matrix<double, 3, 3>, 3>&) noexcept;

}  // namespace farrier::estimation
