#include "control/discretise.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace farrier::control {
namespace {

using Matrix4 = Eigen::Matrix4d;
using Vector4 = Eigen::Vector4d;

constexpr int kMaxBalancingSweeps = 12;
constexpr int kMaxSquarings = 40;
constexpr double kPadeNorm = 0.5;  // [6/6] at this norm errs by less than 1e-17 relative

/// Powers of two s_i that bring the rows and columns of diag(1/s) m diag(s) to like size (Osborne 1960). Powers of
/// two, so that balancing and its undoing add no rounding.
Vector4 balance(Matrix4& m) noexcept {
  Vector4 scale = Vector4::Ones();
  for (int sweep = 0; sweep < kMaxBalancingSweeps; ++sweep) {
    bool changed = false;
    for (int i = 0; i < 4; ++i) {
      const double diagonal = std::abs(m(i, i));
      const double column = m.col(i).lpNorm<1>() - diagonal;
      const double row = m.row(i).lpNorm<1>() - diagonal;
      // The last row is zero: its state (the held input) may be scaled freely, so its column is shrunk to one.
      const double ratio = i == 3 ? 1.0 / column : std::sqrt(row / column);
      if (!(ratio > 0.0) || !std::isfinite(ratio)) {
        continue;
      }
      const int exponent = static_cast<int>(std::lround(std::log2(ratio)));
      if (exponent != 0) {
        const double factor = std::ldexp(1.0, exponent);
        m.col(i) *= factor;
        m.row(i) /= factor;
        scale(i) *= factor;
        changed = true;
      }
    }
    if (!changed) {
      break;
    }
  }
  return scale;
}

/// exp(m) for ||m||_1 <= kPadeNorm: N(m) N(-m)^-1 with the coefficients of the [6/6] approximant.
Matrix4 exponential_of_small(const Matrix4& m) noexcept {
  const Matrix4 m2 = m * m;
  const Matrix4 m4 = m2 * m2;
  const Matrix4 m6 = m4 * m2;
  const Matrix4 one = Matrix4::Identity();
  const Matrix4 even = 665280.0 * one + 75600.0 * m2 + 840.0 * m4 + m6;
  const Matrix4 odd = m * (332640.0 * one + 10080.0 * m2 + 42.0 * m4);
  return (even - odd).partialPivLu().solve(even + odd);
}

}  // namespace

DiscreteModel discretise(const Eigen::Matrix3d& a, const Eigen::Vector3d& b, double period_s) noexcept {
  Matrix4 m = Matrix4::Zero();
  m.topLeftCorner<3, 3>() = a * period_s;
  m.topRightCorner<3, 1>() = b * period_s;
  if (!m.allFinite() || !(period_s > 0.0)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {Eigen::Matrix3d::Constant(nan), Eigen::Vector3d::Constant(nan)};
  }
  const Vector4 scale = balance(m);
  const double norm = m.cwiseAbs().colwise().sum().maxCoeff();
  const int squarings =
      norm > kPadeNorm ? std::min(static_cast<int>(std::ceil(std::log2(norm / kPadeNorm))), kMaxSquarings) : 0;
  Matrix4 exponential = exponential_of_small(m * std::ldexp(1.0, -squarings));
  for (int i = 0; i < squarings; ++i) {
    exponential = (exponential * exponential).eval();
  }
  exponential = (scale.asDiagonal() * exponential * scale.cwiseInverse().asDiagonal()).eval();
  return {exponential.topLeftCorner<3, 3>(), exponential.topRightCorner<3, 1>()};
}

}  // namespace farrier::control
