#include "diagnosis/data/time_line.hpp"

#include <algorithm>
#include <cstddef>

namespace farrier::diagnosis {

double median_step(std::span<const double> time_s) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    if (time_s[i] > time_s[i - 1]) {
      steps.push_back(time_s[i] - time_s[i - 1]);
    }
  }
  if (steps.empty()) {
    return 0.0;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

double mean_step(const std::vector<double>& time_s) {
  const double median = median_step(time_s);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double step = time_s[i] - time_s[i - 1];
    if (step <= kGap * median) {
      sum += step;
      ++count;
    }
  }
  return count == 0 ? median : sum / static_cast<double>(count);
}

TimeLine::TimeLine(const std::vector<double>& time_s) {
  const auto count = static_cast<double>(time_s.size());
  const double middle = 0.5 * (count - 1.0);
  const double origin = time_s.front();  // keeps the digits of a time of day
  double mean = 0.0, slope = 0.0, square = 0.0;
  for (const double time : time_s) {
    mean += (time - origin) / count;
  }
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double place = static_cast<double>(i) - middle;
    slope += place * (time_s[i] - origin - mean);
    square += place * place;
  }
  period_s = slope / square;
  first_s = origin + mean - middle * period_s;
  double least = 0.0, most = 0.0;
  for (std::size_t i = 0; i < time_s.size(); ++i) {
    const double off = time_s[i] - first_s - static_cast<double>(i) * period_s;
    least = std::min(least, off);
    most = std::max(most, off);
  }
  straying_s = most - least;
}

}  // namespace farrier::diagnosis
