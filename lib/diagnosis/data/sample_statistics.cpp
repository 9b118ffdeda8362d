#include "diagnosis/data/sample_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace farrier::diagnosis {
namespace {

constexpr double kRounding = 1e-9;

std::optional<Agreement> agreement_over(std::span<const double> position, std::span<const double> velocity,
                                        double period_s, std::size_t width) {
  if ((position.size() - 1) / width < 8) {
    return std::nullopt;
  }
  std::vector<double> own, other;
  for (std::size_t begin = 0; begin + width < position.size(); begin += width) {
    double integral = 0.5 * (velocity[begin] + velocity[begin + width]);
    for (std::size_t i = begin + 1; i < begin + width; ++i) {
      integral += velocity[i];
    }
    own.push_back(integral / static_cast<double>(width));
    other.push_back((position[begin + width] - position[begin]) /
                    (static_cast<double>(width) * period_s));
  }
  // A spike of either would outweigh all the rest.
  const double own_limit = magnitude(own, 0.98);
  const double other_limit = magnitude(other, 0.98);
  std::vector<double> own_kept, other_kept;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (std::abs(own[i]) <= own_limit && std::abs(other[i]) <= other_limit) {
      own_kept.push_back(own[i]);
      other_kept.push_back(other[i]);
    }
  }
  const double own_mean = mean(own_kept);
  const double other_mean = mean(other_kept);
  const double own_rms = rms(own_kept, own_mean);
  const double other_rms = rms(other_kept, other_mean);
  double products = 0.0;
  for (std::size_t i = 0; i < own_kept.size(); ++i) {
    products += (own_kept[i] - own_mean) * (other_kept[i] - other_mean) / static_cast<double>(own_kept.size());
  }
  if (!(own_rms > kRounding * own_limit) || !(other_rms > kRounding * other_limit)) {
    return std::nullopt;  // frozen
  }
  return Agreement{products / (other_rms * other_rms), products / (own_rms * other_rms)};
}

}  // namespace

double quantile(std::span<const double> values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

double magnitude(std::span<const double> values, double share) {
  std::vector<double> magnitudes;
  for (const double value : values) {
    magnitudes.push_back(std::abs(value));
  }
  return quantile(magnitudes, share);
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rms(std::span<const double> values, double middle) {
  double sum = 0.0;
  for (const double value : values) {
    sum += (value - middle) * (value - middle);
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double standard_deviation(std::span<const double> values) { return rms(values, mean(values)); }

std::optional<Agreement> agreement_of(std::span<const double> position, std::span<const double> velocity,
                                      double period_s) {
  std::optional<Agreement> best;
  for (const double duration_s : {0.01, 0.03, 0.1, 0.3}) {
    const auto width = static_cast<std::size_t>(std::max(2.0, std::round(duration_s / period_s)));
    const auto agreement = agreement_over(position, velocity, period_s, width);
    if (agreement && (!best || std::abs(agreement->correlation) > std::abs(best->correlation))) {
      best = agreement;
    }
  }
  return best;
}

}  // namespace farrier::diagnosis
