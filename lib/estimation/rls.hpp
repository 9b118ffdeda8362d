#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/regression.hpp"
#include "estimation/ud_factors.hpp"

namespace farrier::estimation {

/// Settings of an estimator. Unit: that of the normalised signals, 1.
struct RlsParams {
  double forgetting_factor = 0.9;   ///< lambda of (6.7), (0, 1]; remembers 1/(1 - lambda) samples (6.22)
  double initial_covariance = 1e3;  ///< diagonal of the first P, [1e-40, 1e40]
  double covariance_limit = 1e6;    ///< largest trace of P, [N * initial_covariance, 1e40]; 1e40: none
  double regressor_min = 0.0;       ///< norm below which a regressor is left out, [0, 1e40)
};

/// Settings of a joint's estimator; the joint leaves out small regressors itself.
inline RlsParams rls_params_of(const EstimatorParams& params) noexcept {
  return {.forgetting_factor = params.forgetting_factor,
          .initial_covariance = params.initial_covariance,
          .covariance_limit = params.covariance_limit,
          .regressor_min = 0.0};
}

/// Recursive least squares with forgetting (Hubacher 2014, (6.21)) for y = Theta h + noise: three measurements y, one
/// regressor h of N entries, Theta 3 x N. For the direct identification of 6.2, y is the state of this tick, h state
/// and input of the tick before, and Theta is [A, B].
///
/// The three rows share one N x N covariance P, kept in factors. It is the textbook's 3N x 3N one without its zeros and
/// copies (docs/derivations/shared-covariance.md). N = 3..5.
template <int N>
class Rls {
 public:
  static constexpr int kSize = N;
  using Regressor = Eigen::Matrix<double, N, 1>;
  using Parameters = Eigen::Matrix<double, 3, N>;
  using Covariance = Eigen::Matrix<double, N, N>;

  /// Returns an estimator that starts from theta0. Refuses settings out of range and a theta0 that is not finite.
  static Result<Rls> create(const RlsParams& params, const Parameters& theta0 = Parameters::Zero());

  /// Its method, and create() with the settings of a joint's estimator; `noise_variance` is the sensors', normalised.
  static constexpr EstimationMethod kMethod = EstimationMethod::kRls;
  static Result<Rls> of(const EstimatorParams& params, const Eigen::Vector3d&, const Parameters& theta0) {
    return create(rls_params_of(params), theta0);
  }

  /// Takes one sample, (6.21). Forgets only while trace(P) / lambda stays within the covariance limit, so that P is
  /// bounded without excitation (6.24). A sample that is left out or refused changes nothing but status().
  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y) noexcept;

  /// As after create() with this theta0; entries that are not finite become zero.
  void reset(const Parameters& theta0) noexcept { reset(theta0, Regressor::Constant(params_.initial_covariance)); }

  /// The same with P = diag(variances), of which each is taken as at most the initial one.
  void reset(const Parameters& theta0, const Regressor& variances) noexcept;

  /// Theta, one row per measurement.
  Parameters parameters() const noexcept;

  /// P, N x N, symmetric; the same for every row.
  Covariance covariance(int row = 0) const noexcept;

  double covariance_trace() const noexcept { return p_.trace(); }

  /// Variance of the noise of each measurement: weighted sum of the products of prediction errors before and after each
  /// sample, (1 / weight) sum_k lambda^(n-k) e[k|k-1] e[k|k]. Once weight() has settled the recursion is s <- lambda s
  /// + (1 - lambda) e[k|k-1] e[k|k]. The sum is the residual of the weighted least-squares fit, so it is too small by
  /// the factor (weight - N) / weight. It also holds the squared error of theta0, over the initial covariance, until
  /// that is forgotten. Zero before the first sample.
  Eigen::Vector3d residual_variance() const noexcept;

  /// First-order variance of one parameter, row 0..2, column 0..N-1: residual variance of the row times P(column,
  /// column).
  double parameter_variance(int row, int column) const noexcept;

  /// Number of samples that the estimate rests on: sum of lambda^k over those taken.
  double weight() const noexcept { return weight_; }

  /// Samples taken since the start or reset().
  std::int64_t samples() const noexcept { return samples_; }

  /// Result of the last update().
  RlsStatus status() const noexcept { return status_; }

  /// Forgetting factors of the last sample taken, by row: lambda, or 1 while the covariance is at its limit.
  Eigen::Vector3d forgetting() const noexcept {
    return Eigen::Vector3d::Constant(limited_ ? 1.0 : params_.forgetting_factor);
  }

  /// True if the last sample taken was not forgotten for, because the covariance is at its limit.
  bool forgetting_limited() const noexcept { return limited_; }

 private:
  explicit Rls(const RlsParams& params) noexcept;

  RlsParams params_;
  double forget_below_ = 0.0;  // trace up to which a sample is taken with forgetting
  double inverse_forgetting_ = 1.0;
  double regressor_min_squared_ = 0.0;
  std::array<Eigen::Array4d, N> theta_{};  // column of Theta, and a zero that fills the vector register
  Eigen::Array4d residual_sum_ = Eigen::Array4d::Zero();
  UdFactors<N> p_;
  double weight_ = 0.0;
  std::int64_t samples_ = 0;
  RlsStatus status_ = RlsStatus::kNotYetSet;
  bool limited_ = false;
};

}  // namespace farrier::estimation
