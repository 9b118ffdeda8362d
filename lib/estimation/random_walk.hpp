#pragma once

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/regression.hpp"

namespace farrier::estimation {

/// The parameters as a random walk, followed by a Kalman filter (Hubacher 2014, B.3.1, (B.16), (B.17)). P and the drift
/// are divided by the variance of the measurement's noise, as P is in Rls. The three rows therefore share P, and the
/// noise variance is measured, residual_variance(), and not assumed. N = 3..5.
template <int N>
class RandomWalk : public Regression<N> {
 public:
  using typename Regression<N>::Regressor;
  using typename Regression<N>::Parameters;
  using typename Regression<N>::Covariance;

  /// Covariance as in RlsParams. Refuses settings out of range by name.
  static Result<RandomWalk> create(const RandomWalkParams& params, double initial_covariance, double covariance_limit,
                                   const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kKalman;
  static Result<RandomWalk> of(const EstimatorParams& params, const Eigen::Vector3d&, const Parameters& theta0) {
    return create(params.kalman.value_or(RandomWalkParams{}), params.initial_covariance, params.covariance_limit,
                  theta0);
  }

  /// Takes one sample. The parameters drift only while trace(P) stays within the covariance limit.
  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y) noexcept;

  /// P, the same for every row.
  const Covariance& covariance(int = 0) const noexcept { return p_; }

  double covariance_trace() const noexcept { return p_.trace(); }

 private:
  RandomWalk(const RandomWalkParams& params, double initial_covariance, double covariance_limit,
             const Parameters& theta0) noexcept;

  double drift_;
  double initial_covariance_;
  double covariance_limit_;
  Covariance p_;
};

}  // namespace farrier::estimation
