#include "estimation/estimator.hpp"

#include <cmath>

namespace farrier::estimation {

Result<Done> validate(const JointScales& scales) {
  const auto positive = [](double x) { return x > 0.0 && std::isfinite(x); };
  if (!scales.state.allFinite() || !(scales.state.array() > 0).all() || !positive(scales.current_A) ||
      !positive(scales.period_s)) {
    return Error{"the scales of states and current, and the period, must be positive and finite"};
  }
  if (!scales.sensor_noise.allFinite() || !(scales.sensor_noise.array() >= 0).all() ||
      !std::isfinite(scales.home_position)) {
    return Error{"sensor noise must not be negative, and it and the home position finite"};
  }
  if (scales.input_delay_ticks < 0 || scales.input_delay_ticks > 2) {
    return Error{"the input delay must be 0 to 2 ticks"};
  }
  return Done{};
}

}  // namespace farrier::estimation
