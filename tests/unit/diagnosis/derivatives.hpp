#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "diagnosis/model/joint_sides.hpp"

namespace farrier::diagnosis {

/// Root of the mean square of measured less simulated over that of measured, from a sample on.
inline double relative_error(const std::vector<double>& measured, const std::vector<double>& simulated,
                             std::size_t from) {
  double error = 0.0;
  double power = 1e-60;
  for (std::size_t i = from; i < measured.size(); ++i) {
    error += (measured[i] - simulated[i]) * (measured[i] - simulated[i]);
    power += measured[i] * measured[i];
  }
  return std::sqrt(error / power);
}

/// Expects derivatives of a channel by the number `parameter` of a model's only effect to be those of central
/// differences over `share` of it, and its values those of a simulation without derivatives.
inline void expect_slopes(const JointSides& joint, const JointData& data, const Model& middle, std::size_t parameter,
                          Channel channel, double share = 1e-4) {
  const Observer observer;
  const Span all{0, data.size()};
  const char* const name = plant::effect_info(middle.effects[0].id).name;
  std::vector<double> jacobian;
  const auto value = joint.simulate_lanes(data, all, middle, channel, observer, {kNominals + parameter}, jacobian);
  EXPECT_LT(relative_error(joint.simulate(data, all, middle, channel, observer), value, 0), 1e-9) << name;
  const double step = share * std::abs(middle.effects[0].fitted[parameter]);
  Model above = middle;
  Model below = middle;
  above.effects[0].fitted[parameter] += step;
  below.effects[0].fitted[parameter] -= step;
  const auto high = joint.simulate(data, all, above, channel, observer);
  const auto low = joint.simulate(data, all, below, channel, observer);
  std::vector<double> slopes;
  for (std::size_t i = 0; i < value.size(); ++i) {
    slopes.push_back((high[i] - low[i]) / (2.0 * step));
  }
  // Branches (a deadband's edge, a contact) flip between the two sides at single samples.
  EXPECT_LT(relative_error(slopes, jacobian, 0), 0.05) << name << " " << parameter;
}

}  // namespace farrier::diagnosis
