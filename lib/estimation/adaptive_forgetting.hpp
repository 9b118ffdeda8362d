#pragma once

#include <array>

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/regression.hpp"
#include "estimation/ud_factors.hpp"

namespace farrier::estimation {

/// Recursive least squares whose forgetting follows the prediction error of each measurement (Hubacher 2014, 9.1.1,
/// (9.1)-(9.3)): what noise of the sensors explains is no reason to forget. Each row forgets by itself, so each has a
/// covariance of its own, and lambda is at least 1 - 2 / (3 N). N = 3..5.
template <int N>
class AdaptiveForgetting : public Regression<N> {
 public:
  using typename Regression<N>::Regressor;
  using typename Regression<N>::Parameters;
  using typename Regression<N>::Covariance;

  /// `noise_variance`: sigma_v^2 of each measurement, [0, 1e40]; where it is 0 every error is one to forget for.
  /// Covariance as in RlsParams. Refuses settings out of range by name.
  static Result<AdaptiveForgetting> create(const AdaptiveForgettingParams& params, double initial_covariance,
                                           double covariance_limit, const Eigen::Vector3d& noise_variance,
                                           const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kAff;
  static Result<AdaptiveForgetting> of(const EstimatorParams& params, const Eigen::Vector3d& noise_variance,
                                       const Parameters& theta0) {
    return create(params.aff.value_or(AdaptiveForgettingParams{}), params.initial_covariance, params.covariance_limit,
                  noise_variance, theta0);
  }

  /// Takes one sample, which has been multiplied by `weight` > 0 (and its noise with it).
  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y, double weight = 1.0) noexcept;

  /// P of a row, 0..2.
  Covariance covariance(int row) const noexcept { return p_[static_cast<std::size_t>(row)].matrix(); }

  /// The largest of the three traces.
  double covariance_trace() const noexcept;

 private:
  AdaptiveForgetting(const AdaptiveForgettingParams& params, double initial_covariance, double covariance_limit,
                     const Eigen::Vector3d& noise_variance, const Parameters& theta0) noexcept;

  AdaptiveForgettingParams params_;
  double covariance_limit_;
  Eigen::Array3d noise_floor_;                           // c_1 sigma_v^2
  Eigen::Array3d error_power_ = Eigen::Array3d::Zero();  // sigma_k of (9.2)
  std::array<UdFactors<N>, 3> p_;
};

}  // namespace farrier::estimation
