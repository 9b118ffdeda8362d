#include "estimation/instrumental_variable.hpp"

#include <cmath>

namespace farrier::estimation {
namespace {

// An instrument is to be the regressor without its noise: one many times as large is a simulation that has run away.
constexpr double kLargestRatio = 10.0;

}  // namespace

template <int N>
Result<InstrumentalVariable<N>> InstrumentalVariable<N>::create(const RlsParams& params, const Parameters& theta0) {
  FARRIER_TRY(Rls<N>::create(params, theta0));
  if (params.regressor_min != 0.0) {
    return Error{"regressor_min of instrumental variables must be 0: samples that say nothing are the owner's to leave out"};
  }
  return InstrumentalVariable(params, theta0);
}

template <int N>
InstrumentalVariable<N>::InstrumentalVariable(const RlsParams& params, const Parameters& theta0) noexcept
    : Regression<N>(theta0), params_(params) {
  begin_anew();
}

template <int N>
void InstrumentalVariable<N>::begin_anew() noexcept {
  p_ = params_.initial_covariance * Covariance::Identity();
  m_ = Covariance::Identity() / params_.initial_covariance;
}

template <int N>
RlsStatus InstrumentalVariable<N>::update(const Regressor& h, const Eigen::Vector3d& y,
                                          const Regressor& instrument) noexcept {
  Eigen::Vector3d e;
  if (!this->innovation(h, y, e)) {
    return this->status_;
  }
  Regressor xi = instrument;
  Regressor p_xi = p_ * xi;
  refused_ = !(xi.squaredNorm() <= kLargestRatio * kLargestRatio * h.squaredNorm() && h.dot(p_xi) >= 0.0);
  if (refused_) {
    xi = h;
    p_xi = p_ * h;
  }
  this->limited_ = !(p_.norm() <= params_.forgetting_factor * params_.covariance_limit);
  const double lambda = this->limited_ ? 1.0 : params_.forgetting_factor;
  const double information = h.dot(p_xi);
  if (!(information >= 0.0)) {
    begin_anew();
    return this->status_ = RlsStatus::kCovarianceNotPositiveDefinite;
  }
  // K = P xi / (h'P xi + lambda), Theta <- Theta + e K', (B.18)
  const Regressor gain = p_xi / (information + lambda);
  if (!this->accept(this->theta_ + e * gain.transpose())) {
    return this->status_;
  }
  // P <- (P - K h'P) / lambda, (B.18)
  const Eigen::Matrix<double, 1, N> hp = h.transpose() * p_;
  p_ = (p_ - gain * hp) / lambda;
  m_ = lambda * m_ + xi * xi.transpose();
  this->account(e, Eigen::Vector3d::Constant(lambda / (information + lambda)), Eigen::Vector3d::Constant(lambda));
  const double size = p_.norm();
  if (!(size <= params_.covariance_limit && size * m_.norm() * size <= kLargest)) {
    begin_anew();
    return this->status_ = RlsStatus::kCovarianceNotPositiveDefinite;
  }
  return this->status_ = RlsStatus::kOk;
}

template <int N>
typename InstrumentalVariable<N>::Covariance InstrumentalVariable<N>::covariance(int) const noexcept {
  const Covariance product = p_ * m_ * p_.transpose();
  return 0.5 * (product + product.transpose());
}

template class InstrumentalVariable<3>;
template class InstrumentalVariable<4>;
template class InstrumentalVariable<5>;

}  // namespace farrier::estimation
