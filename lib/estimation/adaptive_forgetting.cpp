#include "estimation/adaptive_forgetting.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::estimation {

template <int N>
Result<AdaptiveForgetting<N>> AdaptiveForgetting<N>::create(const AdaptiveForgettingParams& params,
                                                            double initial_covariance, double covariance_limit,
                                                            const Eigen::Vector3d& noise_variance,
                                                            const Parameters& theta0) {
  if (!(params.forgetting_min > 0.0 && params.forgetting_min <= 1.0)) {
    return Error{"aff.forgetting_min must be above 0 and at most 1"};
  }
  if (!(params.noise_factor >= 0.0 && params.noise_factor <= kLargest)) {
    return Error{"aff.noise_factor must not be negative, and at most 1e40"};
  }
  if (!(params.error_memory >= 0.0 && params.error_memory < 1.0)) {
    return Error{"aff.error_memory must be in [0, 1)"};
  }
  if (const auto refused = check_covariance(N, initial_covariance, covariance_limit)) {
    return *refused;
  }
  if (!((noise_variance.array() >= 0.0).all() && (noise_variance.array() <= kLargest).all())) {
    return Error{"the variance of the sensors' noise must be within 0 and 1e40"};
  }
  if (!theta0.allFinite()) {
    return Error{"the first estimate must be finite"};
  }
  return AdaptiveForgetting(params, initial_covariance, covariance_limit, noise_variance, theta0);
}

template <int N>
AdaptiveForgetting<N>::AdaptiveForgetting(const AdaptiveForgettingParams& params, double initial_covariance,
                                          double covariance_limit, const Eigen::Vector3d& noise_variance,
                                          const Parameters& theta0) noexcept
    : Regression<N>(theta0),
      params_(params),
      covariance_limit_(covariance_limit),
      noise_floor_(params.noise_factor * noise_variance.array()),
      p_{UdFactors<N>(initial_covariance, covariance_limit), UdFactors<N>(initial_covariance, covariance_limit),
         UdFactors<N>(initial_covariance, covariance_limit)} {}

template <int N>
RlsStatus AdaptiveForgetting<N>::update(const Regressor& h, const Eigen::Vector3d& y, double weight) noexcept {
  Eigen::Vector3d e;
  if (!this->innovation(h, y, e)) {
    return this->status_;
  }
  // e^ = sign(e) max(|e| - sqrt(c_1 sigma_v^2), 0), (9.1), of the sample without its weight
  const Eigen::Array3d beyond_noise = (e.array().abs() / weight - noise_floor_.sqrt()).max(0.0);
  const Eigen::Array3d power = beyond_noise.square().min(kLargestSquaredError);
  // sigma_k = beta sigma_{k-1} + (1 - beta) e^^2, (9.2)
  error_power_ = params_.error_memory * error_power_ + (1.0 - params_.error_memory) * power;
  constexpr int kUnknowns = 3 * N;  // 12 in the thesis, (6.35)
  Eigen::Vector3d lambda, left;
  Parameters theta = this->theta_;
  bool sound = true;
  this->limited_ = false;
  for (int row = 0; row < 3; ++row) {
    // lambda_k = 1 - 2 sigma_k / (M (sigma_k + c_1 sigma_v^2)), (9.3), M all unknown parameters; then its bounds
    const double sum = error_power_(row) + noise_floor_(row);
    const double wanted = sum > 0.0 ? 1.0 - 2.0 * error_power_(row) / (kUnknowns * sum) : 1.0;
    lambda(row) = std::clamp(wanted, params_.forgetting_min, 1.0);
    UdFactors<N>& p = p_[static_cast<std::size_t>(row)];
    if (p.trace() > lambda(row) * covariance_limit_) {
      this->limited_ |= lambda(row) < 1.0;
      lambda(row) = 1.0;
    }
    const auto gain = p.update(h, lambda(row), 1.0 / lambda(row));
    for (int j = 0; j < N; ++j) {
      theta(row, j) += e(row) * gain.inverse * gain.direction[j];
    }
    left(row) = lambda(row) * gain.inverse;
    sound &= p.hold_limit();
  }
  if (!this->accept(theta)) {
    return this->status_;
  }
  this->account(e, left, lambda);
  return this->status_ = sound ? RlsStatus::kOk : RlsStatus::kCovarianceNotPositiveDefinite;
}

template <int N>
double AdaptiveForgetting<N>::covariance_trace() const noexcept {
  return std::max({p_[0].trace(), p_[1].trace(), p_[2].trace()});
}

template class AdaptiveForgetting<3>;
template class AdaptiveForgetting<4>;
template class AdaptiveForgetting<5>;

}  // namespace farrier::estimation
