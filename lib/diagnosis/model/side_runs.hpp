#pragma once

// Runs of the simulations of a joint's two sides, of either kind of joint. A drive simulation has read(k) and
// advance(k, error, pull), one of a load settle(k), read() and advance(k, pull). T is double, or a number with
// derivatives.

#include <array>
#include <cmath>
#include <vector>

#include "diagnosis/data/joint_data.hpp"
#include "diagnosis/model/model.hpp"
#include "plant/terms/terms.hpp"

namespace farrier::diagnosis {

/// Share of an error that a simulation drawn with this time constant loses in a period.
inline double pull_of(double period_s, double time_constant_s) noexcept {
  return 1.0 - std::exp(-period_s / time_constant_s);
}

/// True if the load at a sample is the one in its model.
inline bool knows_load(const JointData& data, std::size_t k) noexcept {
  return data.swing.empty() || data.swing[k] != 0;
}

/// Simulated reading of each sample's force sensor over a span.
template <class T, class Drive>
std::vector<T> run_drive(const JointData& data, Span span, Drive drive, double observer_s) {
  std::vector<T> out;
  out.reserve(span.size());
  const double pull = pull_of(data.period_s, observer_s);
  for (std::size_t k = span.begin; k < span.end; ++k) {
    const T force = drive.read(k);
    out.push_back(force);
    drive.advance(k, data.force[k] - force, pull);
  }
  return out;
}

/// Simulated motion of the load over a span, as JointData::motion. Where the load is not the one in its model, the
/// simulation stays at the measurement. The smoother turns the error in position into an error in velocity plus a
/// weighted error in position, where a constant force shows. It is linear.
template <class T, class Load>
std::vector<T> run_load(const JointData& data, Span span, Load load, double observer_s) {
  std::vector<T> out;
  out.reserve(span.size());
  const double pull = pull_of(data.period_s, observer_s);
  for (std::size_t k = span.begin; k < span.end; ++k) {
    if (!knows_load(data, k)) {
      load.settle(k);
    }
    out.push_back(data.measured_position[k] - load.read());
    load.advance(k, pull);
  }
  for (std::size_t from = 0; from < out.size();) {
    std::size_t to = from + 1;
    while (to < out.size() && knows_load(data, span.begin + to) == knows_load(data, span.begin + from)) {
      ++to;
    }
    const std::vector<T> stretch(out.begin() + std::ptrdiff_t(from), out.begin() + std::ptrdiff_t(to));
    const auto error = data.smoother.template smooth<T>(stretch, {stretch[0], T(0.0), T(0.0)});
    for (std::size_t i = from; i < to; ++i) {
      const std::array<T, 3>& e = error[i - from];
      out[i] = data.motion[span.begin + i] - (e[1] + e[0] / JointData::kMotionTime_s);
    }
    from = to;
  }
  return out;
}

/// Simulated readings of the velocity sensor over a span.
template <class T>
std::vector<T> run_velocity_sensor(const JointData& data, Span span, plant::TermSet<T>& terms) {
  std::vector<T> out;
  out.reserve(span.size());
  for (std::size_t k = span.begin; k < span.end; ++k) {
    out.push_back(terms.on_velocity(T(data.velocity[k])));
  }
  return out;
}

/// As JointSides::errors_ahead, of the force.
template <class Drive>
std::vector<double> drive_errors_ahead(const JointData& data, Span span, Drive drive, double observer_s,
                                       std::size_t steps, std::size_t every) {
  std::vector<double> errors;
  for (std::size_t k = span.begin; k + steps < span.end; ++k) {
    if ((k - span.begin) % every == 0) {
      Drive ahead = drive;
      for (std::size_t i = k; i < k + steps; ++i) {
        ahead.read(i);
        ahead.advance(i, 0.0, 0.0);
      }
      errors.push_back(data.force[k + steps] - ahead.read(k + steps));
    }
    const double force = drive.read(k);
    drive.advance(k, data.force[k] - force, pull_of(data.period_s, observer_s));
  }
  return errors;
}

/// The same of the load's position.
template <class Load>
std::vector<double> load_errors_ahead(const JointData& data, Span span, Load load, double observer_s, std::size_t steps,
                                      std::size_t every) {
  std::vector<double> errors;
  for (std::size_t k = span.begin; k + steps < span.end; ++k) {
    if ((k - span.begin) % every == 0) {
      Load ahead = load;
      ahead.settle(k);
      for (std::size_t i = k; i < k + steps; ++i) {
        ahead.advance(i, 0.0);
      }
      const double error = data.position[k + steps] - ahead.read();
      errors.push_back(knows_load(data, k) && knows_load(data, k + steps) ? error / JointData::kMotionTime_s : 0.0);
    }
    load.advance(k, pull_of(data.period_s, observer_s));
  }
  return errors;
}

}  // namespace farrier::diagnosis
