#include "control/law/low_pass.hpp"

#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::control {

std::optional<FilterCoefficients> design_low_pass(const LowPassParams& params, double rate_Hz) noexcept {
  const double share = params.cut_off_Hz / rate_Hz;
  if (params.cut_off_Hz == 0.0) {
    return FilterCoefficients{};
  }
  if (!(share > 0.0 && share <= kLargestCutOffShare) || (params.order != 1 && params.order != 2) ||
      (params.order == 2 && !(std::isfinite(params.damping) && params.damping > 0.0))) {
    return std::nullopt;
  }
  // s / w = (1 / g) (1 - z^-1) / (1 + z^-1), g = tan(pi share)
  constexpr double kPi = 3.14159265358979323846;
  const portable::SineCosine angle = portable::sincos(kPi * share);
  const double g = angle.sine / angle.cosine;
  if (params.order == 1) {
    const double gain = g / (1.0 + g);
    return FilterCoefficients{{gain, gain, 0.0}, {(g - 1.0) / (g + 1.0), 0.0}};
  }
  const double norm = 1.0 / (1.0 + 2.0 * params.damping * g + g * g);
  const double gain = g * g * norm;
  return FilterCoefficients{{gain, 2.0 * gain, gain},
                            {2.0 * (g * g - 1.0) * norm, (1.0 - 2.0 * params.damping * g + g * g) * norm}};
}

void LowPass::settle(double value) noexcept {
  second_ = (c_.b[2] - c_.a[1]) * value;
  first_ = (c_.b[1] - c_.a[0]) * value + second_;
}

double LowPass::take(double value) noexcept {
  const double out = c_.b[0] * value + first_;
  first_ = c_.b[1] * value - c_.a[0] * out + second_;
  second_ = c_.b[2] * value - c_.a[1] * out;
  return out;
}

}  // namespace farrier::control
