#include "control/design/measurement_filter.hpp"

#include <Eigen/Core>

namespace farrier::control {
MeasurementFilter oversampled(const FilterCoefficients& low_pass, int conversions) noexcept {
  // Poles: those of a tick's worth of the low-pass.
  Eigen::Matrix2d step;
  step << -low_pass.a[0], 1.0, -low_pass.a[1], 0.0;
  Eigen::Matrix2d tick = Eigen::Matrix2d::Identity();
  for (int i = 0; i < conversions; ++i) {
    tick = (tick * step).eval();
  }
  const bool filtered = low_pass.a[0] != 0.0 || low_pass.a[1] != 0.0 || low_pass.b[1] != 0.0;
  MeasurementFilter mean;
  mean.order = (filtered ? 2 : 0) + (conversions == 1 ? 0 : 1);
  if (filtered) {
    mean.a[1] = -tick.trace();
    mean.a[2] = tick.determinant();
  }
  // Zeros: by the response to an impulse at one tick.
  MeasurementFilter::Polynomial response{};
  LowPass running(low_pass);
  for (std::size_t k = 0; k <= static_cast<std::size_t>(mean.order); ++k) {
    double sum = 0.0;
    for (int i = 1; i <= conversions; ++i) {
      const double now = static_cast<double>(i) / conversions;  // share of the value at the tick; the rest is before it
      sum += running.take(k == 0 ? now : (k == 1 ? 1.0 - now : 0.0));
    }
    response[k] = sum / conversions;
  }
  for (std::size_t k = 0; k <= static_cast<std::size_t>(mean.order); ++k) {
    mean.b[k] = 0.0;
    for (std::size_t i = 0; i <= k; ++i) {
      mean.b[k] += mean.a[i] * response[k - i];
    }
  }
  return mean;
}

}  // namespace farrier::control
