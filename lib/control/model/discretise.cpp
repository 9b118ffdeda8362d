#include "control/model/discretise.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

#include "control/numerics/balance.hpp"

namespace farrier::control {
namespace {

constexpr int kMaxSquarings = 40;
constexpr double kPadeNorm = 0.5;  // [6/6] at this norm errs by less than 1e-17 relative

/// exp(m) for ||m||_1 <= kPadeNorm: N(m) N(-m)^-1 with the coefficients of the [6/6] approximant.
template <int N>
Eigen::Matrix<double, N, N> exponential_of_small(const Eigen::Matrix<double, N, N>& m) noexcept {
  using Matrix = Eigen::Matrix<double, N, N>;
  const Matrix m2 = m * m;
  const Matrix m4 = m2 * m2;
  const Matrix m6 = m4 * m2;
  const Matrix one = Matrix::Identity();
  const Matrix even = 665280.0 * one + 75600.0 * m2 + 840.0 * m4 + m6;
  const Matrix odd = m * (332640.0 * one + 10080.0 * m2 + 42.0 * m4);
  return (even - odd).partialPivLu().solve(even + odd);
}

template <int N>
SampledModel<N> sampled(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                        double period_s) noexcept {
  using Matrix = Eigen::Matrix<double, N + 1, N + 1>;
  Matrix m = Matrix::Zero();
  m.template topLeftCorner<N, N>() = a * period_s;
  m.template topRightCorner<N, 1>() = b * period_s;
  if (!m.allFinite() || !(period_s > 0.0)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {Eigen::Matrix<double, N, N>::Constant(nan), Eigen::Matrix<double, N, 1>::Constant(nan)};
  }
  const Eigen::Matrix<double, N + 1, 1> scale = balance<true>(m);
  const double norm = m.cwiseAbs().colwise().sum().maxCoeff();
  int exponent = 0;  // norm / kPadeNorm < 2^exponent
  std::frexp(norm / kPadeNorm, &exponent);
  const int squarings = norm > kPadeNorm ? std::min(exponent, kMaxSquarings) : 0;
  Matrix exponential = exponential_of_small<N + 1>(m * std::ldexp(1.0, -squarings));
  for (int i = 0; i < squarings; ++i) {
    exponential = (exponential * exponential).eval();
  }
  exponential = (scale.asDiagonal() * exponential * scale.cwiseInverse().asDiagonal()).eval();
  return {exponential.template topLeftCorner<N, N>(), exponential.template topRightCorner<N, 1>()};
}

}  // namespace

template <int N>
SampledModel<N> discretise(const plant::StateSpace<N>& model, double period_s) noexcept {
  return sampled<N>(model.a, model.b, period_s);
}

template SampledModel<3> discretise<3>(const plant::StateSpace<3>&, double) noexcept;
template SampledModel<4> discretise<4>(const plant::StateSpace<4>&, double) noexcept;

DiscreteModel discretise(const Eigen::Matrix3d& a, const Eigen::Vector3d& b, double period_s) noexcept {
  return sampled<3>(a, b, period_s);
}

}  // namespace farrier::control
