#pragma once

// The recursive estimators available to a joint, behind one variant, and the places of its signals in the regressor.

#include <Eigen/Core>

#include <type_traits>
#include <variant>

#include "core/result.hpp"
#include "estimation/adaptive_forgetting.hpp"
#include "estimation/directional_forgetting.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/instrumental_variable.hpp"
#include "estimation/random_walk.hpp"
#include "estimation/rls.hpp"

namespace farrier::estimation {

template <template <int> class... Methods>
using InEverySize = std::variant<Methods<3>..., Methods<4>..., Methods<5>...>;

/// A joint's regression by any method, with 3 to 5 regressors. The class of a method has its kMethod, and `of`, which
/// creates it.
using LinearRegression =
    InEverySize<Rls, AdaptiveForgetting, RandomWalk, InstrumentalVariable, VariableDirection, SubspaceOfInformation>;

/// Places in the regressor [x] v F u [1].
struct Columns {
  int velocity, force, input, bias;
};

inline Columns columns_of(bool position) noexcept {
  const int first = position ? 1 : 0;
  return {first, first + 1, first + 2, first + 3};
}

/// The regression of `params.method`, from [A, B] = `a`, `b`; `noise_variance` is the sensors'. All normalised. Refuses
/// settings out of range by name.
Result<LinearRegression> make_regression(const EstimatorParams& params, const Eigen::Vector3d& noise_variance,
                                         const Eigen::Matrix3d& a, const Eigen::Vector3d& b);

/// True if a regression takes the regressor as measured, with an instrument.
template <class Engine>
inline constexpr bool kTakesInstrument = std::is_same_v<Engine, InstrumentalVariable<Engine::kSize>>;

/// Gives a regression one sample, multiplied by `weight`; `instrument` is ignored by methods that take none.
template <class Engine>
RlsStatus teach(Engine& engine, double weight, const typename Engine::Regressor& h, const Eigen::Vector3d& y,
                const typename Engine::Regressor& instrument) noexcept {
  if constexpr (kTakesInstrument<Engine>) {
    return engine.update(weight * h, weight * y, weight * instrument);
  } else if constexpr (std::is_same_v<Engine, AdaptiveForgetting<Engine::kSize>>) {
    return engine.update(weight * h, weight * y, weight);
  } else {
    return engine.update(weight * h, weight * y);
  }
}

}  // namespace farrier::estimation
