#include "diagnosis/wiring/wiring_signals.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::diagnosis {
namespace {

constexpr double kPass_s = 0.006;  // of each of three means
constexpr double kQuick_s = 1.0;   // what lasts longer is taken out of quick signals

/// Mean of the 2 half + 1 values about each; of fewer at the ends.
std::vector<double> moving_mean(const std::vector<double>& values, std::size_t half) {
  std::vector<double> means(values.size());
  double sum = 0.0;
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (; end < std::min(values.size(), i + half + 1); ++end) {
      sum += values[end];
    }
    for (; begin + half < i; ++begin) {
      sum -= values[begin];
    }
    means[i] = sum / static_cast<double>(end - begin);
  }
  return means;
}

std::vector<double> low_passed(const std::vector<double>& values, std::size_t half) {
  return moving_mean(moving_mean(moving_mean(values, half), half), half);
}

std::vector<double> middles(const std::vector<double>& values) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    at.push_back(0.5 * (values[i] + values[i + 1]));
  }
  return at;
}

/// Derivative of samples at the middles between them.
std::vector<double> slopes(const std::vector<double>& values, double period_s) {
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    at.push_back((values[i + 1] - values[i]) / period_s);
  }
  return at;
}

/// Derivative of values at the same times; 0 at both ends.
std::vector<double> derivative(const std::vector<double>& values, double period_s) {
  std::vector<double> at(values.size(), 0.0);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    at[i] = (values[i + 1] - values[i - 1]) / (2.0 * period_s);
  }
  return at;
}

std::vector<double> quick(std::vector<double> values, double period_s) {
  const auto half = static_cast<std::size_t>(0.5 * kQuick_s / period_s);
  const std::vector<double> slow = moving_mean(values, half);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] -= slow[i];
  }
  return values;
}

/// The current times the root of the drop at its port over that at half the supply, for pressures that add to the
/// supply. The drop is kept away from nothing, where a reversed force would put it.
std::vector<double> through_ports(const Recording& recording, const plant::ActuatorParams& a, double sign) {
  std::vector<double> flow;
  const double supply = a.supply_pressure_Pa;
  for (std::size_t i = 0; i < recording.valve_current_A.size(); ++i) {
    const double share = (sign * recording.force[i] / supply + a.area_b) / (a.area_a + a.area_b);
    const double u = recording.valve_current_A[i];
    const double drop = std::clamp(u > 0.0 ? 1.0 - share : share, 0.1, 0.9);
    flow.push_back(u * std::sqrt(2.0 * drop));
  }
  return flow;
}

}  // namespace

WiringSignals::WiringSignals(const Recording& recording, const robot::Joint& joint) {
  const double h = recording.period_s;
  const auto half = static_cast<std::size_t>(std::max(1.0, std::round(0.5 * kPass_s / h)));
  width = 3 * half + 3;
  const auto pass = [half](const std::vector<double>& values) { return low_passed(values, half); };

  const std::vector<double> x = pass(recording.position);
  position = {middles(x), slopes(x, h), {}, {}};
  position[2] = derivative(position[1], h);
  position[3] = derivative(position[2], h);
  const std::vector<double> f = pass(recording.force);
  force = {middles(f), slopes(f, h), {}};
  force[2] = derivative(force[1], h);
  quick_force = quick(force[0], h);
  if (!recording.velocity_derived && !recording.velocity.empty()) {
    const std::vector<double> v = pass(recording.velocity);
    velocity = {middles(v), slopes(v, h), {}};
    velocity[2] = derivative(velocity[1], h);
    travel.resize(v.size(), 0.0);
    for (std::size_t i = 1; i < v.size(); ++i) {
      travel[i] = travel[i - 1] + 0.5 * h * (v[i - 1] + v[i]);
    }
    travel = quick(middles(travel), h);
    quick_velocity = {quick(velocity[0], h), quick(velocity[1], h), quick(velocity[2], h)};
  }
  if (!recording.valve_current_A.empty()) {
    // A current acts from its sample to the next: its value at the middle is the sample's.
    const auto held = [&](const std::vector<double>& values) {
      std::vector<double> at = pass(values);
      at.pop_back();
      return at;
    };
    current[2] = held(recording.valve_current_A);
    for (const std::size_t reversed : {0, 1}) {
      current[reversed] =
          joint.electric ? current[2] : held(through_ports(recording, joint.actuator, reversed == 0 ? 1.0 : -1.0));
    }
  }
  if (!recording.pressure_a_Pa.empty()) {
    pressure_a = middles(pass(recording.pressure_a_Pa));
  }
  if (!recording.pressure_b_Pa.empty()) {
    pressure_b = middles(pass(recording.pressure_b_Pa));
  }
  load_known.assign(size(), 1);
  for (std::size_t i = 0; i < recording.swing.size(); ++i) {
    if (recording.swing[i] == 0) {
      const std::size_t from = i > width ? i - width : 0;
      std::fill(load_known.begin() + static_cast<std::ptrdiff_t>(from),
                load_known.begin() + static_cast<std::ptrdiff_t>(std::min(size(), i + width)), char{0});
    }
  }
}

}  // namespace farrier::diagnosis
