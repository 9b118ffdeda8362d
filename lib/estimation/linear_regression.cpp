#include "estimation/linear_regression.hpp"

namespace farrier::estimation {
namespace {

template <int N>
Eigen::Matrix<double, 3, N> first_estimate(bool position, const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  Eigen::Matrix<double, 3, N> theta = Eigen::Matrix<double, 3, N>::Zero();
  const Columns columns = columns_of(position);
  if (position) {
    theta.col(0) = a.col(0);
  }
  theta.col(columns.velocity) = a.col(1);
  theta.col(columns.force) = a.col(2);
  theta.col(columns.input) = b;
  return theta;
}

template <class Engine>
Result<LinearRegression> any(Result<Engine> engine) {
  if (!engine) {
    return engine.error();
  }
  return LinearRegression(std::move(engine).value());
}

template <int N>
Result<LinearRegression> make(const EstimatorParams& params, const Eigen::Vector3d& noise_variance,
                              const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  const auto theta = first_estimate<N>(params.position, a, b);
  const RlsParams rls{.forgetting_factor = params.forgetting_factor,
                      .initial_covariance = params.initial_covariance,
                      .covariance_limit = params.covariance_limit,
                      .regressor_min = 0.0};
  const auto directional = [&](double excitation_min) {
    return DirectionalParams{.forgetting_factor = params.forgetting_factor,
                             .initial_covariance = params.initial_covariance,
                             .excitation_min = excitation_min};
  };
  switch (params.method) {
    case EstimationMethod::kRls: break;
    case EstimationMethod::kGreyBox: return Error{"greybox is no regression: GreyBoxEstimator is it"};
    case EstimationMethod::kAff:
      return any(AdaptiveForgetting<N>::create(params.aff.value_or(AdaptiveForgettingParams{}),
                                               params.initial_covariance, params.covariance_limit, noise_variance,
                                               theta));
    case EstimationMethod::kKalman:
      return any(RandomWalk<N>::create(params.kalman.value_or(RandomWalkParams{}), params.initial_covariance,
                                       params.covariance_limit, theta));
    case EstimationMethod::kIv: return any(InstrumentalVariable<N>::create(rls, theta));
    case EstimationMethod::kVdf:
      return any(VariableDirection<N>::create(
          directional(params.vdf.value_or(VariableDirectionParams{}).excitation_min), theta));
    case EstimationMethod::kSift:
      return any(SubspaceOfInformation<N>::create(directional(params.sift.value_or(SubspaceParams{}).excitation_min),
                                                  theta));
  }
  return any(Rls<N>::create(rls, theta));
}

}  // namespace

Result<LinearRegression> make_regression(const EstimatorParams& params, const Eigen::Vector3d& noise_variance,
                                         const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  switch (params.columns()) {
    case 3: return make<3>(params, noise_variance, a, b);
    case 4: return make<4>(params, noise_variance, a, b);
    default: return make<5>(params, noise_variance, a, b);
  }
}

}  // namespace farrier::estimation
