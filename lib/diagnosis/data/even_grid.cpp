#include "diagnosis/data/even_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farrier::diagnosis {

EvenGrid::EvenGrid(std::vector<double> time_s, std::size_t periods)
    : time_s_(std::move(time_s)),
      period_s_((time_s_.back() - time_s_.front()) / static_cast<double>(periods)),
      at_s_(periods + 1),
      from_(periods + 1) {
  for (std::size_t k = 0, row = 0; k <= periods; ++k) {
    at_s_[k] = k == periods ? time_s_.back() : time_s_.front() + static_cast<double>(k) * period_s_;
    while (row + 2 < time_s_.size() && time_s_[row + 1] <= at_s_[k]) {
      ++row;
    }
    from_[k] = row;
  }
}

std::vector<double> EvenGrid::carry(const std::vector<double>& values, Carry how, double& error) const {
  std::vector<double> result;
  error = 0.0;
  if (values.empty()) {
    return result;
  }
  double square = 0.0;
  for (std::size_t k = 0; k < at_s_.size(); ++k) {
    const std::size_t row = from_[k];
    if (how == Carry::kFlag) {
      result.push_back(at_s_[k] >= time_s_[row + 1] ? values[row + 1] : values[row]);
    } else if (how == Carry::kHeld) {
      result.push_back(mean_of_held(values, k));
    } else {
      const double share = (at_s_[k] - time_s_[row]) / (time_s_[row + 1] - time_s_[row]);
      const double straight = values[row] + share * (values[row + 1] - values[row]);
      result.push_back(cubic(values, row, share));
      square += (result.back() - straight) * (result.back() - straight);
    }
  }
  error = std::sqrt(square / static_cast<double>(at_s_.size()));
  return result;
}

/// Mean over a period from an even time on of values that act from their row to the next.
double EvenGrid::mean_of_held(const std::vector<double>& values, std::size_t place) const {
  double sum = 0.0;
  double begin = at_s_[place];
  const double end = begin + period_s_;
  for (std::size_t i = from_[place]; i < values.size() && begin < end; ++i) {
    const double until = i + 1 < values.size() ? std::min(time_s_[i + 1], end) : end;
    if (until > begin) {
      sum += (until - begin) * values[i];
      begin = until;
    }
  }
  return sum / (end - at_s_[place]);
}

/// Slope at a row of the parabola through it and its neighbours.
double EvenGrid::slope(const std::vector<double>& values, std::size_t row) const {
  const std::size_t last = values.size() - 1;
  const auto chord = [&](std::size_t i) { return (values[i + 1] - values[i]) / (time_s_[i + 1] - time_s_[i]); };
  if (row == 0 || row == last) {
    return chord(row == 0 ? 0 : last - 1);
  }
  const double before = time_s_[row] - time_s_[row - 1];
  const double after = time_s_[row + 1] - time_s_[row];
  return (after * chord(row - 1) + before * chord(row)) / (before + after);
}

double EvenGrid::cubic(const std::vector<double>& values, std::size_t row, double share) const {
  const double s = share;
  const double step = time_s_[row + 1] - time_s_[row];
  return values[row] * (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s) + step * slope(values, row) * s * (1.0 - s) * (1.0 - s) +
         values[row + 1] * s * s * (3.0 - 2.0 * s) + step * slope(values, row + 1) * s * s * (s - 1.0);
}

}  // namespace farrier::diagnosis
