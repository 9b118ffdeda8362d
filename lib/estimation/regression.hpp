#pragma once

// Common part of the recursive estimators of y = Theta h + noise.

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/result.hpp"

namespace farrier::estimation {

/// Outcome of one sample: Hubacher (2014), Table F.1, "Estimator Subclass", with its numbers. Its 5, inputs too small,
/// is decided earlier (EstimateFlag::kNotExciting).
enum class RlsStatus : std::uint8_t {
  kNotYetSet = 1,                      ///< no sample yet
  kOk = 2,                             ///< the sample was taken
  kRegressorTooSmall = 3,              ///< left out: the regressor is too small (wind-up, 6.1.3)
  kCovarianceNotPositiveDefinite = 4,  ///< taken; the covariance was beyond repair and was reset
  kNotFinite = 6,                      ///< refused: not finite, or regressor or measurement beyond 1e40
};

/// Name of a status, for people.
const char* to_string(RlsStatus status) noexcept;

// With h, y and P up to 1e40 a fit over n samples has |Theta| <= 2 sqrt(n trace P) |y| <= 2e60 sqrt(n), its errors stay
// below 1e101 sqrt(n), and their squares are finite. A separate check refuses larger values from rounding.
inline constexpr double kLargest = 1e40;
inline constexpr double kLargestSquare = kLargest * kLargest;
inline constexpr double kLargestSquaredError = 1e250;
inline constexpr double kLargestParameter = 1e80;

/// Refuses an initial covariance outside [1e-40, 1e40] and a limit of the trace below `columns` times it or above 1e40.
std::optional<Error> check_covariance(int columns, double initial, double limit);

/// The estimate and its residuals, for three measurements and a regressor of N entries. The derived class adds the rule
/// of the covariance.
template <int N>
class Regression {
 public:
  static constexpr int kSize = N;
  using Regressor = Eigen::Matrix<double, N, 1>;
  using Parameters = Eigen::Matrix<double, 3, N>;
  using Covariance = Eigen::Matrix<double, N, N>;

  /// Theta, one row per measurement.
  const Parameters& parameters() const noexcept { return theta_; }

  /// Variance of the noise of each measurement, as Rls::residual_variance(); each row with its own forgetting.
  Eigen::Vector3d residual_variance() const noexcept {
    return (weight_ > 0.0).select(residual_sum_ / weight_.max(1.0), 0.0).matrix();
  }

  /// Samples taken since the start.
  std::int64_t samples() const noexcept { return samples_; }

  /// Result of the last update().
  RlsStatus status() const noexcept { return status_; }

  /// Forgetting factors of the last sample taken, by row, [0, 1].
  const Eigen::Vector3d& forgetting() const noexcept { return forgetting_; }

  /// True if a bound of the covariance limited the forgetting of the last sample taken.
  bool forgetting_limited() const noexcept { return limited_; }

 protected:
  explicit Regression(const Parameters& theta0) noexcept : theta_(theta0) {}

  /// e = y - Theta h, (6.2). False, with status() set, if something is not finite or too large.
  bool innovation(const Regressor& h, const Eigen::Vector3d& y, Eigen::Vector3d& e) noexcept {
    e = y - theta_ * h;
    if (h.squaredNorm() <= kLargestSquare && y.squaredNorm() <= kLargestSquare &&
        e.squaredNorm() <= kLargestSquaredError) {
      return true;
    }
    status_ = RlsStatus::kNotFinite;
    return false;
  }

  /// Theta <- theta. False, with status() set, if theta is not finite or too large to compute errors from.
  bool accept(const Parameters& theta) noexcept {
    if (theta.cwiseAbs().maxCoeff() <= kLargestParameter && theta.allFinite()) {
      theta_ = theta;
      return true;
    }
    status_ = RlsStatus::kNotFinite;
    return false;
  }

  /// Adds a sample to the residuals: the sample leaves the share `left` of each error, `lambda` is the forgetting.
  void account(const Eigen::Vector3d& e, const Eigen::Vector3d& left, const Eigen::Vector3d& lambda) noexcept {
    residual_sum_ = lambda.array() * residual_sum_ + e.array().square() * left.array().max(0.0);
    weight_ = lambda.array() * weight_ + 1.0;
    forgetting_ = lambda;
    ++samples_;
  }

  Parameters theta_;
  RlsStatus status_ = RlsStatus::kNotYetSet;
  bool limited_ = false;

 private:
  Eigen::Array3d residual_sum_ = Eigen::Array3d::Zero();
  Eigen::Array3d weight_ = Eigen::Array3d::Zero();
  Eigen::Vector3d forgetting_ = Eigen::Vector3d::Ones();
  std::int64_t samples_ = 0;
};

}  // namespace farrier::estimation
