#include "estimation/random_walk.hpp"

namespace farrier::estimation {
namespace {

// Samples over which residuals are averaged: this filter forgets by drift, and has no lambda of its own.
constexpr double kResidualMemory = 0.998;

}  // namespace

template <int N>
Result<RandomWalk<N>> RandomWalk<N>::create(const RandomWalkParams& params, double initial_covariance,
                                            double covariance_limit, const Parameters& theta0) {
  if (!(params.parameter_drift >= 0.0 && params.parameter_drift <= kLargest)) {
    return Error{"kalman.parameter_drift must not be negative, and at most 1e40"};
  }
  if (const auto refused = check_covariance(N, initial_covariance, covariance_limit)) {
    return *refused;
  }
  if (!theta0.allFinite()) {
    return Error{"the first estimate must be finite"};
  }
  return RandomWalk(params, initial_covariance, covariance_limit, theta0);
}

template <int N>
RandomWalk<N>::RandomWalk(const RandomWalkParams& params, double initial_covariance, double covariance_limit,
                          const Parameters& theta0) noexcept
    : Regression<N>(theta0),
      drift_(params.parameter_drift),
      initial_covariance_(initial_covariance),
      covariance_limit_(covariance_limit),
      p_(initial_covariance * Covariance::Identity()) {}

template <int N>
RlsStatus RandomWalk<N>::update(const Regressor& h, const Eigen::Vector3d& y) noexcept {
  Eigen::Vector3d e;
  if (!this->innovation(h, y, e)) {
    return this->status_;
  }
  // K = P h / (h'P h + 1), Theta <- Theta + e K', (B.17)
  const Regressor ph = p_ * h;
  const double left = 1.0 / (1.0 + h.dot(ph));
  const Regressor gain = left * ph;
  if (!this->accept(this->theta_ + e * gain.transpose())) {
    return this->status_;
  }
  // P <- (I - K h') P (I - K h')' + K K' + R, which is (B.17) written as a sum of squares (Bucy and Joseph 1968).
  const Covariance kept = Covariance::Identity() - gain * h.transpose();
  const Covariance half = kept * p_;
  Covariance p;
  for (int i = 0; i < N; ++i) {
    for (int j = i; j < N; ++j) {
      p(i, j) = half.row(i).dot(kept.row(j)) + gain(i) * gain(j);
      p(j, i) = p(i, j);
    }
  }
  this->limited_ = !(p.trace() + N * drift_ <= covariance_limit_);
  if (!this->limited_) {
    p.diagonal().array() += drift_;
  }
  const Eigen::Vector3d lambda = Eigen::Vector3d::Constant(kResidualMemory);
  this->account(e, Eigen::Vector3d::Constant(left), lambda);
  if (!(p.allFinite() && p.trace() <= kLargest && (p.diagonal().array() > 0.0).all())) {
    p_ = initial_covariance_ * Covariance::Identity();
    return this->status_ = RlsStatus::kCovarianceNotPositiveDefinite;
  }
  p_ = p;
  return this->status_ = RlsStatus::kOk;
}

template class RandomWalk<3>;
template class RandomWalk<4>;
template class RandomWalk<5>;

}  // namespace farrier::estimation
