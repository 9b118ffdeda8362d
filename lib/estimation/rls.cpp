#include "estimation/rls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

// Every loop below has a length known to the compiler; unrolled, the factors stay in registers.
#define FARRIER_UNROLL _Pragma("GCC unroll 8")

namespace farrier::estimation {
namespace {

// With h, y and P up to 1e40 a fit over n samples has |Theta| <= 2 sqrt(n trace P) |y| <= 2e60 sqrt(n), its errors stay
// below 1e101 sqrt(n), and their squares are finite. What rounding might add to that is refused by its own check.
constexpr double kLargest = 1e40;
constexpr double kLargestSquare = kLargest * kLargest;
constexpr double kLargestSquaredError = 1e250;

// Standard deviations further apart than 1/eps cannot be told from one another: entries of D stop at eps^2 of the
// largest covariance.
constexpr double kSmallestShare =
    std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();

// What a covariance put on its limit stays short of it: more than the trace's own rounding.
constexpr double kRoom = 1e-14;

bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

const char* to_string(RlsStatus status) noexcept {
  switch (status) {
    case RlsStatus::kNotYetSet: return "not yet set";
    case RlsStatus::kOk: return "ok";
    case RlsStatus::kRegressorTooSmall: return "regressor too small";
    case RlsStatus::kCovarianceNotPositiveDefinite: return "covariance not positive definite";
    case RlsStatus::kInputTooSmall: return "input too small";
    case RlsStatus::kNotFinite: return "not finite";
  }
  return "unknown status";
}

template <int N>
Result<Rls<N>> Rls<N>::create(const RlsParams& params, const Parameters& theta0) {
  if (!(params.forgetting_factor > 0.0 && params.forgetting_factor <= 1.0)) {
    return Error{"forgetting_factor must be above 0 and at most 1, is " + std::to_string(params.forgetting_factor)};
  }
  if (!within(params.initial_covariance, 1.0 / kLargest, kLargest)) {
    return Error{"initial_covariance must be within 1e-40 and 1e40"};
  }
  if (!within(params.covariance_limit, N * params.initial_covariance, kLargest)) {
    return Error{"covariance_limit must be at least initial_covariance times the " + std::to_string(N) +
                 " regressors, and at most 1e40"};
  }
  if (!(params.regressor_min >= 0.0 && params.regressor_min < kLargest)) {
    return Error{"regressor_min must not be negative and stay below 1e40"};
  }
  if (!theta0.allFinite()) {
    return Error{"the first estimate must be finite"};
  }
  Rls rls;
  rls.params_ = params;
  rls.forget_below_ = params.forgetting_factor * params.covariance_limit;
  rls.inverse_forgetting_ = 1.0 / params.forgetting_factor;
  rls.regressor_min_squared_ = params.regressor_min * params.regressor_min;
  rls.d_min_ = kSmallestShare * params.covariance_limit;
  rls.reset(theta0);
  return rls;
}

template <int N>
RlsStatus Rls<N>::update(const Regressor& h, const Eigen::Vector3d& y) noexcept {
  // e = y - Theta h, (6.2)
  Eigen::Array4d e(y(0), y(1), y(2), 0.0);
  double size = 0.0;
  FARRIER_UNROLL
  for (int j = 0; j < N; ++j) {
    e -= theta_[j] * h(j);
    size += h(j) * h(j);
  }
  const Eigen::Array4d e_squared = e * e;
  if (!(size <= kLargestSquare && y.squaredNorm() <= kLargestSquare && e_squared.sum() <= kLargestSquaredError)) {
    return status_ = RlsStatus::kNotFinite;
  }
  if (size < regressor_min_squared_) {
    return status_ = RlsStatus::kRegressorTooSmall;
  }
  const bool forget = trace_ <= forget_below_;
  const double lambda = forget ? params_.forgetting_factor : 1.0;
  const double inverse_lambda = forget ? inverse_forgetting_ : 1.0;

  // Bierman (1977), V.3, with lambda for the variance of the measurement: f = U'h, g = D f,
  // alpha_j = lambda + sum_{i<=j} f_i g_i, the last of which is lambda + h'P h.
  double f[N], g[N], alpha[N], inverse[N];
  double sum = lambda;
  FARRIER_UNROLL
  for (int j = 0; j < N; ++j) {
    f[j] = h(j);
    FARRIER_UNROLL
    for (int i = 0; i < j; ++i) {
      f[j] += u_[j][i] * h(i);
    }
    g[j] = d_[j] * f[j];
    sum += f[j] * g[j];
    alpha[j] = sum;
    inverse[j] = 1.0 / sum;
  }
  // D <- D alpha_{j-1} / alpha_j / lambda; U_j <- U_j - f_j / alpha_{j-1} b; b <- b + U_j g_j, which ends as P h.
  double b[N];
  double trace = 0.0;
  FARRIER_UNROLL
  for (int j = 0; j < N; ++j) {
    const double before = j == 0 ? lambda : alpha[j - 1];
    const double d = std::max(d_[j] * (before * inverse[j]) * inverse_lambda, d_min_);
    double column = 1.0;
    if (j > 0) {
      const double c = f[j] * inverse[j - 1];
      FARRIER_UNROLL
      for (int i = 0; i < j; ++i) {
        const double u = u_[j][i];
        const double updated = u - c * b[i];
        b[i] += u * g[j];
        u_[j][i] = updated;
        column += updated * updated;
      }
    }
    b[j] = g[j];
    d_[j] = d;
    trace += d * column;
  }
  trace_ = trace;

  // Theta <- Theta + e (P h)' / (lambda + h'P h), (6.21)
  const Eigen::Array4d scaled = e * inverse[N - 1];
  FARRIER_UNROLL
  for (int j = 0; j < N; ++j) {
    theta_[j] += scaled * b[j];
  }
  // The error after the sample is lambda / (lambda + h'P h) of the one before.
  residual_sum_ = lambda * residual_sum_ + e_squared * (lambda * inverse[N - 1]);
  weight_ = lambda * weight_ + 1.0;
  ++samples_;
  if (!(trace <= params_.covariance_limit)) [[unlikely]] {
    return status_ = repair_covariance() ? RlsStatus::kOk : RlsStatus::kCovarianceNotPositiveDefinite;
  }
  return status_ = RlsStatus::kOk;
}

template <int N>
void Rls<N>::reset(const Parameters& theta0) noexcept {
  for (int j = 0; j < N; ++j) {
    theta_[j].setZero();
    for (int i = 0; i < 3; ++i) {
      theta_[j](i) = std::isfinite(theta0(i, j)) ? theta0(i, j) : 0.0;
    }
  }
  residual_sum_.setZero();
  weight_ = 0.0;
  samples_ = 0;
  status_ = RlsStatus::kNotYetSet;
  set_covariance(params_.initial_covariance);
}

template <int N>
void Rls<N>::inflate(double factor) noexcept {
  if (factor >= 1.0) {
    scale_covariance(std::min(factor, std::max((1.0 - kRoom) * params_.covariance_limit / trace_, 1.0)));
  }
}

template <int N>
void Rls<N>::set_covariance(double diagonal) noexcept {
  for (int j = 0; j < N; ++j) {
    std::fill(u_[j], u_[j] + N, 0.0);
    d_[j] = diagonal;
  }
  trace_ = trace_of_factors();
}

template <int N>
void Rls<N>::scale_covariance(double factor) noexcept {
  for (double& d : d_) {
    d = std::max(factor * d, d_min_);
  }
  trace_ = trace_of_factors();
}

template <int N>
double Rls<N>::trace_of_factors() const noexcept {
  double trace = 0.0;
  for (int j = 0; j < N; ++j) {
    double column = 1.0;
    for (int i = 0; i < j; ++i) {
      column += u_[j][i] * u_[j][i];
    }
    trace += d_[j] * column;
  }
  return trace;
}

// Above the limit by rounding: back onto it. By more than scaling can mend, because entries of D lie at their floor:
// the factors mean nothing any more.
template <int N>
bool Rls<N>::repair_covariance() noexcept {
  if (std::isfinite(trace_)) {
    scale_covariance((1.0 - kRoom) * params_.covariance_limit / trace_);
    if (trace_ <= params_.covariance_limit) {
      return true;
    }
  }
  set_covariance(params_.initial_covariance);
  return false;
}

template <int N>
typename Rls<N>::Parameters Rls<N>::parameters() const noexcept {
  Parameters theta;
  for (int j = 0; j < N; ++j) {
    theta.col(j) = theta_[j].template head<3>();
  }
  return theta;
}

template <int N>
typename Rls<N>::Covariance Rls<N>::covariance() const noexcept {
  Covariance u = Covariance::Identity();
  for (int j = 0; j < N; ++j) {
    for (int i = 0; i < j; ++i) {
      u(i, j) = u_[j][i];
    }
  }
  Covariance p;
  for (int i = 0; i < N; ++i) {
    for (int j = i; j < N; ++j) {
      double sum = 0.0;
      for (int k = j; k < N; ++k) {
        sum += u(i, k) * d_[k] * u(j, k);
      }
      p(i, j) = sum;
      p(j, i) = sum;
    }
  }
  return p;
}

template <int N>
Eigen::Vector3d Rls<N>::residual_variance() const noexcept {
  if (weight_ == 0.0) {
    return Eigen::Vector3d::Zero();
  }
  return residual_sum_.template head<3>().matrix() / weight_;
}

template <int N>
double Rls<N>::parameter_variance(int row, int column) const noexcept {
  double p = 0.0;
  for (int k = column; k < N; ++k) {
    const double u = k == column ? 1.0 : u_[k][column];
    p += u * u * d_[k];
  }
  return residual_variance()(row) * p;
}

template class Rls<3>;
template class Rls<4>;
template class Rls<5>;
template class Rls<6>;

}  // namespace farrier::estimation
