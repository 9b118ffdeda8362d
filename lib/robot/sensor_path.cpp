#include "robot/sensor_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "config/visitor.hpp"

namespace farrier::robot {
namespace {

using control::LowPassParams;
using control::MeasurementFilter;

constexpr double kLeastLagTicks = 0.5;
constexpr double kButterworth = 0.7071;

/// Group delay at low frequencies, s.
double lag_s(const LowPassParams& filter) noexcept {
  if (!(filter.cut_off_Hz > 0.0)) {
    return 0.0;
  }
  const double time_constant_s = 1.0 / (2.0 * std::numbers::pi * filter.cut_off_Hz);
  return (filter.order == 1 ? 1.0 : 2.0 * filter.damping) * time_constant_s;
}

LowPassParams equaliser(const LowPassParams& own, const LowPassParams& slowest, double period_s) noexcept {
  const double lacking_s = lag_s(slowest) - lag_s(own);
  if (lacking_s < kLeastLagTicks * period_s) {
    return {};
  }
  if (!(own.cut_off_Hz > 0.0)) {
    return slowest;
  }
  const double cut_off_Hz = kButterworth / (std::numbers::pi * lacking_s);
  return {std::min(cut_off_Hz, control::kLargestCutOffShare / period_s), 2, kButterworth};
}

/// The file's checks refuse filters that their rate cannot represent.
control::FilterCoefficients at_rate(const LowPassParams& filter, double rate_Hz) noexcept {
  return control::design_low_pass(filter, rate_Hz).value_or(control::FilterCoefficients{});
}

/// The anti-alias filter and the mean of the conversions.
MeasurementFilter conversion(const Sensors& sensors, double period_s) noexcept {
  return control::oversampled(at_rate(sensors.anti_alias, sensors.oversampling / period_s), sensors.oversampling);
}

}  // namespace

ChannelFilters equalisers(const Joint& joint, double period_s) noexcept {
  if (!joint.equalises_filters) {
    return {};
  }
  const Sensors& s = joint.sensors;
  const LowPassParams slowest = std::max({s.position, s.velocity, s.force},
                                         [](const auto& one, const auto& other) { return lag_s(one) < lag_s(other); });
  return {equaliser(s.position, slowest, period_s), equaliser(s.velocity, slowest, period_s),
          equaliser(s.force, slowest, period_s)};
}

control::FilterEqualiser filter_equaliser(const Joint& joint, double period_s) noexcept {
  const ChannelFilters filters = equalisers(joint, period_s);
  return {at_rate(filters.position, 1.0 / period_s), at_rate(filters.velocity, 1.0 / period_s),
          at_rate(filters.force, 1.0 / period_s)};
}

control::SignalAligner signal_aligner(const Joint& joint, double period_s) noexcept {
  const Sensors& s = joint.sensors;
  return control::SignalAligner(
      {at_rate(s.position, 1.0 / period_s), at_rate(s.velocity, 1.0 / period_s), at_rate(s.force, 1.0 / period_s)});
}

control::MeasurementFilters measurement_filters(const Joint& joint, double period_s) noexcept {
  const Sensors& s = joint.sensors;
  const ChannelFilters equal = equalisers(joint, period_s);
  const MeasurementFilter common = conversion(s, period_s);
  const auto way = [&](const LowPassParams& own, const LowPassParams& equaliser) {
    return in_series(common, in_series(control::measurement_filter(at_rate(own, 1.0 / period_s)),
                                       control::measurement_filter(at_rate(equaliser, 1.0 / period_s))));
  };
  return {way(s.position, equal.position), way(s.velocity, equal.velocity), way(s.force, equal.force)};
}

Robot with_noise(Robot robot, double factor) {
  for (Joint& joint : robot.joints) {
    joint.noise.position *= factor;
    joint.noise.velocity *= factor;
    joint.noise.force *= factor;
  }
  return robot;
}

std::string filters_text(const Joint& joint) {
  const Sensors& s = joint.sensors;
  std::string text;
  const auto add = [&](const char* name, const LowPassParams& filter) {
    if (filter.cut_off_Hz > 0.0) {
      text += (text.empty() ? "" : ", ") + std::string(name) + " filter " +
              config::number_text(std::round(filter.cut_off_Hz)) + " Hz";
    }
  };
  add("position", s.position);
  add("velocity", s.velocity);
  add("force", s.force);
  add("anti-alias", s.anti_alias);
  return text;
}

}  // namespace farrier::robot
