#include "estimation/linear_regression.hpp"

#include <string>
#include <type_traits>
#include <utility>

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

/// Creates that of the alternatives whose method and size are asked for.
template <int N, class... Engines>
Result<LinearRegression> make(std::type_identity<std::variant<Engines...>>, const EstimatorParams& params,
                              const Eigen::Vector3d& noise_variance, const Eigen::Matrix3d& a,
                              const Eigen::Vector3d& b) {
  Result<LinearRegression> made = Error{std::string(name_of(kEstimationMethods, params.method)) + " is no regression"};
  const auto try_one = [&]<class Engine>(std::type_identity<Engine>) {
    if constexpr (Engine::kSize == N) {
      if (Engine::kMethod == params.method) {
        auto engine = Engine::of(params, noise_variance, first_estimate<N>(params.position, a, b));
        made = engine ? Result<LinearRegression>(LinearRegression(std::move(engine).value())) : engine.error();
      }
    }
  };
  (try_one(std::type_identity<Engines>{}), ...);
  return made;
}

}  // namespace

Result<LinearRegression> make_regression(const EstimatorParams& params, const Eigen::Vector3d& noise_variance,
                                         const Eigen::Matrix3d& a, const Eigen::Vector3d& b) {
  constexpr std::type_identity<LinearRegression> every;
  switch (params.columns()) {
    case 3:
      return make<3>(every, params, noise_variance, a, b);
    case 4:
      return make<4>(every, params, noise_variance, a, b);
    default:
      return make<5>(every, params, noise_variance, a, b);
  }
}

}  // namespace farrier::estimation
