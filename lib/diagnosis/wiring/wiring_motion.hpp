#pragma once

#include <cstddef>
#include <vector>

#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/wiring/wiring_relations.hpp"

namespace farrier::diagnosis {

inline constexpr double kLongestLag_s = 0.05;  ///< of a load cell or a filter of the velocity

/// Standard deviation; 0 for a channel that was not recorded.
inline double standard(const std::vector<double>& values) { return values.empty() ? 0.0 : standard_deviation(values); }

/// Where the motion of a law comes from: true value at i is factor * lines[...][i + late].
struct WiringJudge::Motion {
  const std::vector<double>*x, *v, *a, *jerk;
  double factor;
  int late;
  double lag_s = 0.0;  ///< of the velocity; undone with the next derivative

  double at(const std::vector<double>& of, const std::vector<double>* next, std::size_t i) const {
    const std::size_t k = i + static_cast<std::size_t>(late);
    return factor * (of[k] + (lag_s > 0.0 && next != nullptr ? lag_s * (*next)[k] : 0.0));
  }
  double position(std::size_t i) const { return at(*x, lag_s > 0.0 ? v : nullptr, i); }
  double speed(std::size_t i) const { return at(*v, a, i); }
  double acceleration(std::size_t i) const { return at(*a, jerk, i); }
  double jolt(std::size_t i) const { return jerk == nullptr ? 0.0 : at(*jerk, nullptr, i); }
};

}  // namespace farrier::diagnosis
