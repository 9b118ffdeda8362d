#include "estimation/rls.hpp"

#include <cmath>
#include <string>

namespace farrier::estimation {

template <int N>
Result<Rls<N>> Rls<N>::create(const RlsParams& params, const Parameters& theta0) {
  if (!(params.forgetting_factor > 0.0 && params.forgetting_factor <= 1.0)) {
    return Error{"forgetting_factor must be above 0 and at most 1, is " + std::to_string(params.forgetting_factor)};
  }
  if (const auto refused = check_covariance(N, params.initial_covariance, params.covariance_limit)) {
    return *refused;
  }
  if (!(params.regressor_min >= 0.0 && params.regressor_min < kLargest)) {
    return Error{"regressor_min must not be negative and stay below 1e40"};
  }
  if (!theta0.allFinite()) {
    return Error{"the first estimate must be finite"};
  }
  Rls rls(params);
  rls.reset(theta0);
  return rls;
}

template <int N>
Rls<N>::Rls(const RlsParams& params) noexcept
    : params_(params),
      forget_below_(params.forgetting_factor * params.covariance_limit),
      inverse_forgetting_(1.0 / params.forgetting_factor),
      regressor_min_squared_(params.regressor_min * params.regressor_min),
      p_(params.initial_covariance, params.covariance_limit) {}

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
  const bool forget = p_.trace() <= forget_below_;
  const double lambda = forget ? params_.forgetting_factor : 1.0;
  const double inverse_lambda = forget ? inverse_forgetting_ : 1.0;
  limited_ = !forget;
  const auto [direction, inverse] = p_.update(h, lambda, inverse_lambda);

  // Theta <- Theta + e (P h)' / (lambda + h'P h), (6.21)
  const Eigen::Array4d scaled = e * inverse;
  FARRIER_UNROLL
  for (int j = 0; j < N; ++j) {
    theta_[j] += scaled * direction[j];
  }
  // The error after the sample is lambda / (lambda + h'P h) of the one before.
  residual_sum_ = lambda * residual_sum_ + e_squared * (lambda * inverse);
  weight_ = lambda * weight_ + 1.0;
  ++samples_;
  return status_ = p_.hold_limit() ? RlsStatus::kOk : RlsStatus::kCovarianceNotPositiveDefinite;
}

template <int N>
void Rls<N>::reset(const Parameters& theta0, const Regressor& variances) noexcept {
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
  limited_ = false;
  p_.begin_from(variances);
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
typename Rls<N>::Covariance Rls<N>::covariance(int) const noexcept {
  return p_.matrix();
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
  return residual_variance()(row) * p_.variance(column);
}

template class Rls<3>;
template class Rls<4>;
template class Rls<5>;

}  // namespace farrier::estimation
