#pragma once

#include <Eigen/Core>

namespace farrier::textbook {

/// Hubacher (2014), (6.21) as printed, for three measurements and N regressors. The parameter vector has 3N entries,
/// the regression matrix (6.30), (6.31) is 3 x 3N, the covariance 3N x 3N; N is 3, 4 or 5. estimation::Rls is checked
/// and timed against it. The covariance is reduced by P H'[..]^-1 (H P), 3N x 3 times 3 x 3N. The printed order of the
/// products costs twice the time. With (P H')' in the place of H P an asymmetry grows by 1/lambda per sample until
/// nothing is left.
template <int N>
class TextbookRls {
 public:
  static constexpr int kParameters = 3 * N;

  TextbookRls(double forgetting_factor, double initial_covariance)
      : lambda_(forgetting_factor), p_(initial_covariance * P::Identity()) {}

  void update(const Eigen::Matrix<double, N, 1>& h, const Eigen::Vector3d& y) noexcept;

  /// One row per measurement, as Rls::parameters().
  Eigen::Matrix<double, 3, N> parameters() const {
    return Eigen::Map<const Eigen::Matrix<double, N, 3>>(theta_.data()).transpose();
  }
  const Eigen::Matrix<double, kParameters, kParameters>& covariance() const { return p_; }

 private:
  using P = Eigen::Matrix<double, kParameters, kParameters>;
  double lambda_;
  P p_;
  Eigen::Matrix<double, kParameters, 1> theta_ = Eigen::Matrix<double, kParameters, 1>::Zero();
  Eigen::Matrix<double, 3, kParameters> h_ = Eigen::Matrix<double, 3, kParameters>::Zero();
  Eigen::Matrix<double, 3, kParameters> hp_;
  Eigen::Matrix<double, kParameters, 3> ph_;
  Eigen::Matrix<double, kParameters, 3> k_;
};

}  // namespace farrier::textbook
