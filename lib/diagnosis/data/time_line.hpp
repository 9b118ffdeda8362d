#pragma once

#include <span>
#include <vector>

namespace farrier::diagnosis {

/// Median intervals beyond which samples are missing.
inline constexpr double kGap = 1.5;

/// Median of the intervals that go forward, s; 0 for none.
double median_step(std::span<const double> time_s);

/// Mean of the intervals of rising times without those in which samples are missing, s.
double mean_step(const std::vector<double>& time_s);

/// The straight line through times by row number, by least squares, and the span by which the times stray from it, s.
struct TimeLine {
  double first_s = 0.0, period_s = 0.0, straying_s = 0.0;

  /// At least two times.
  explicit TimeLine(const std::vector<double>& time_s);
};

}  // namespace farrier::diagnosis
