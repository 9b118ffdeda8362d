#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>

#include "core/result.hpp"

namespace farrier::estimation {

/// What one sample did: Hubacher (2014), Table F.1, "Estimator Subclass", in its order and with its numbers.
enum class RlsStatus : std::uint8_t {
  kNotYetSet = 1,                      ///< no sample yet
  kOk = 2,                             ///< the sample was taken
  kRegressorTooSmall = 3,              ///< left out: the regressor tells too little (wind-up, 6.1.3)
  kCovarianceNotPositiveDefinite = 4,  ///< taken; the covariance was beyond repair and is the initial one again
  kInputTooSmall = 5,                  ///< left out by the owner, who knows which regressor is the input
  kNotFinite = 6,                      ///< refused: not finite, or regressor or measurement beyond 1e40
};

/// Name of a status, for people.
const char* to_string(RlsStatus status) noexcept;

/// Settings of an estimator. Unit: that of the normalised signals, 1.
struct RlsParams {
  double forgetting_factor = 0.9;    ///< lambda of (6.7), (0, 1]; remembers 1/(1 - lambda) samples (6.22)
  double initial_covariance = 1e3;   ///< diagonal of the first P, [1e-40, 1e40]
  double covariance_limit = 1e6;     ///< largest trace of P, [N * initial_covariance, 1e40]
  double regressor_min = 0.0;        ///< norm below which a regressor is left out, [0, 1e40)
};

/// Recursive least squares with forgetting (Hubacher 2014, (6.21)) for y = Theta h + noise: three measurements y, one
/// regressor h of N entries, Theta 3 x N. For the direct identification of 6.2, y is the state of this tick, h state
/// and input of the tick before, and Theta is [A, B].
///
/// The three rows share one N x N covariance P, which is the textbook's 3N x 3N one without its zeros and copies
/// (docs/derivations/shared-covariance.md). P is kept as U D U' with U unit upper triangular and D diagonal (Bierman
/// 1977, "Factorization methods for discrete sequential estimation", V.3), D > 0, so P is symmetric and positive
/// definite. N = 3..6.
template <int N>
class Rls {
 public:
  using Regressor = Eigen::Matrix<double, N, 1>;
  using Parameters = Eigen::Matrix<double, 3, N>;
  using Covariance = Eigen::Matrix<double, N, N>;

  /// An estimator that starts from theta0. Refuses settings out of range and a theta0 that is not finite.
  static Result<Rls> create(const RlsParams& params, const Parameters& theta0 = Parameters::Zero());

  /// Takes one sample, (6.21). Forgets only while trace(P) / lambda stays within the covariance limit, so that P is
  /// bounded without excitation (6.24). A sample that is left out or refused changes nothing but status().
  RlsStatus update(const Regressor& h, const Eigen::Vector3d& y) noexcept;

  /// As after create() with this theta0; entries that are not finite become zero.
  void reset(const Parameters& theta0) noexcept;

  /// Multiplies P by `factor` >= 1, at most up to the covariance limit: the plant is known to have changed. Any other
  /// factor changes nothing.
  void inflate(double factor) noexcept;

  /// Theta, one row per measurement.
  Parameters parameters() const noexcept;

  /// P, N x N, symmetric.
  Covariance covariance() const noexcept;

  double covariance_trace() const noexcept { return trace_; }

  /// Variance of the noise of each measurement: weighted sum of the products of prediction errors before and after
  /// each sample, (1 / weight) sum_k lambda^(n-k) e[k|k-1] e[k|k]; once weight() has settled that is
  /// s <- lambda s + (1 - lambda) e[k|k-1] e[k|k]. That sum is the residual of the weighted least-squares fit, so it
  /// comes out (weight - N) / weight too small; it also holds the square of what theta0 was off, over the initial
  /// covariance, until that is forgotten. Zero before the first sample.
  Eigen::Vector3d residual_variance() const noexcept;

  /// First-order variance of one parameter, row 0..2, column 0..N-1: residual variance of the row times P(column,
  /// column).
  double parameter_variance(int row, int column) const noexcept;

  /// How many samples the estimate rests on: sum of lambda^k over those taken.
  double weight() const noexcept { return weight_; }

  /// Samples taken since the start or reset().
  std::int64_t samples() const noexcept { return samples_; }

  /// What the last update() returned.
  RlsStatus status() const noexcept { return status_; }

 private:
  Rls() = default;
  void set_covariance(double diagonal) noexcept;
  void scale_covariance(double factor) noexcept;
  double trace_of_factors() const noexcept;
  bool repair_covariance() noexcept;

  RlsParams params_{};
  double forget_below_ = 0.0;              // trace up to which a sample is taken with forgetting
  double inverse_forgetting_ = 1.0;
  double regressor_min_squared_ = 0.0;
  double d_min_ = 0.0;
  std::array<Eigen::Array4d, N> theta_{};  // column of Theta, and a zero that fills the vector register
  Eigen::Array4d residual_sum_ = Eigen::Array4d::Zero();
  double u_[N][N] = {};                    // [column][row], row < column; the rest is not read
  double d_[N] = {};
  double trace_ = 0.0;
  double weight_ = 0.0;
  std::int64_t samples_ = 0;
  RlsStatus status_ = RlsStatus::kNotYetSet;
};

}  // namespace farrier::estimation
