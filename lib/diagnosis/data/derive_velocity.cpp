#include "diagnosis/data/derive_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace farrier::diagnosis {
namespace {

constexpr int kHighestOrder = 10;
constexpr std::size_t kFewestForNoise = 32;
constexpr std::size_t kJudgedPlaces = 20'000;  ///< at which windows are compared
constexpr double kLongestHalf_s = 0.1;

/// sum of k^2 over -h <= k <= h.
double sum_of_squares(int h) { return h * (h + 1.0) * (2.0 * h + 1.0) / 3.0; }

/// Bias of a window over x''' T^2: (sum of k^4 / sum of k^2) / 6.
double bias_factor(int h) { return (3.0 * h * h + 3.0 * h - 1.0) / 30.0; }

/// Slope at the middle of a window, per sample: sum of k x_k / sum of k^2.
double slope(std::span<const double> x, std::size_t middle, int h) {
  double sum = 0.0;
  for (int k = 1; k <= h; ++k) {
    const auto offset = static_cast<std::size_t>(k);
    sum += k * (x[middle + offset] - x[middle - offset]);
  }
  return sum / sum_of_squares(h);
}

/// Twice the quadratic coefficient of the same parabola, per sample squared.
double curvature(std::span<const double> x, std::size_t middle, int h) {
  const double n = 2.0 * h + 1.0;
  const double mean_square = sum_of_squares(h) / n;
  double sum = 0.0;
  double norm = 0.0;
  for (int k = -h; k <= h; ++k) {
    const double weight = static_cast<double>(k) * k - mean_square;
    sum += weight * x[middle + static_cast<std::size_t>(k + h) - static_cast<std::size_t>(h)];
    norm += weight * weight;
  }
  return norm > 0.0 ? 2.0 * sum / norm : 0.0;
}

/// Step of a sensor whose values are whole numbers of it; 0 where they are not. Steps show where neighbours are equal.
double smallest_step(std::span<const double> values) {
  constexpr double kShareOfEqual = 0.05;
  double least = std::numeric_limits<double>::infinity();
  std::size_t equal = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = std::abs(values[i] - values[i - 1]);
    equal += change == 0.0 ? 1 : 0;
    least = change > 0.0 ? std::min(least, change) : least;
  }
  const auto pairs = static_cast<double>(values.size() - 1);
  if (!std::isfinite(least) || static_cast<double>(equal) < kShareOfEqual * pairs) {
    return 0.0;
  }
  // Differences of decimal numbers are whole only to rounding.
  constexpr double kRounding = 1e-3;
  constexpr double kShareOfWhole = 0.99;
  std::size_t whole = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double steps = (values[i] - values[i - 1]) / least;
    whole += std::abs(steps - std::round(steps)) < kRounding ? 1 : 0;
  }
  return static_cast<double>(whole) >= kShareOfWhole * pairs ? least : 0.0;
}

/// Errors of windows, squared, per sample. With S_h = sum of k^2 a slope has the variance sigma^2 / S_h and its
/// difference D from that of a shorter window sigma^2 (1 / S_shorter - 1 / S_h); what is left of mean D^2 is bias.
class WindowJudge {
 public:
  /// Windows up to `longest` fit at every place that is judged.
  WindowJudge(std::span<const double> position, double sigma, std::size_t longest)
      : position_(position), variance_(sigma * sigma), margin_(longest),
        stride_(std::max<std::size_t>(1, (position.size() - 2 * longest) / kJudgedPlaces)) {}

  double noise(int h) const { return variance_ / sum_of_squares(h); }

  /// Mean square bias of window `of`, from the difference between two others; below 0 by chance.
  double bias(int shorter, int longer, int of) const {
    double sum = 0.0;
    std::size_t places = 0;
    for (std::size_t i = margin_; i + margin_ < position_.size(); i += stride_, ++places) {
      const double difference = slope(position_, i, longer) - slope(position_, i, shorter);
      sum += difference * difference;
    }
    const double unexplained = sum / static_cast<double>(places) - (noise(shorter) - noise(longer));
    const double ratio = bias_factor(of) / (bias_factor(longer) - bias_factor(shorter));
    return ratio * ratio * unexplained;
  }

 private:
  std::span<const double> position_;
  double variance_;
  std::size_t margin_, stride_;
};

}  // namespace

double white_noise(std::span<const double> values) {
  if (values.size() < kFewestForNoise) {
    return 0.0;
  }
  std::vector<double> differences(values.begin(), values.end());
  double variance = std::numeric_limits<double>::infinity();
  double binomial = 1.0;
  for (int order = 1; order <= kHighestOrder; ++order) {
    for (std::size_t i = 0; i + 1 < differences.size(); ++i) {
      differences[i] = differences[i + 1] - differences[i];
    }
    differences.pop_back();
    // binomial(2 d, d) = binomial(2 d - 2, d - 1) 2 (2 d - 1) / d.
    binomial *= 2.0 * (2.0 * order - 1.0) / order;
    double sum = 0.0;
    for (const double difference : differences) {
      sum += difference * difference;
    }
    variance = std::min(variance, sum / static_cast<double>(differences.size()) / binomial);
  }
  const double step = smallest_step(values);
  return std::sqrt(std::max(variance, step * step / 12.0));
}

DerivedVelocity derive_velocity(std::span<const double> position, double period_s) {
  const std::size_t n = position.size();
  DerivedVelocity derived;
  derived.velocity.assign(n, 0.0);
  if (n < 3) {
    return derived;
  }
  const double sigma = white_noise(position);
  const int longest = std::max(1, static_cast<int>(std::min(kLongestHalf_s / period_s, static_cast<double>(n) / 20.0)));
  const WindowJudge judge(position, sigma, static_cast<std::size_t>(longest));
  double least_risk = longest < 2 ? 0.0 : judge.noise(1) + judge.bias(1, 2, 1);
  derived.half_window = 1;
  for (int h = 2; h <= longest; h += std::max(1, h / 4)) {
    // Not cut at 0: what a chance correlation takes from one window it takes from its neighbours.
    if (const double risk = judge.noise(h) + judge.bias(1, h, h); risk < least_risk) {
      derived.half_window = h;
      least_risk = risk;
    }
  }

  const int h = derived.half_window;
  const auto half = static_cast<std::size_t>(h);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t middle = std::clamp(i, half, n - 1 - half);
    const double beside = static_cast<double>(i) - static_cast<double>(middle);
    const double bend = i == middle ? 0.0 : curvature(position, middle, h) * beside;
    derived.velocity[i] = (slope(position, middle, h) + bend) / period_s;
  }
  derived.noise = std::sqrt(judge.noise(h)) / period_s;
  // A reference near by has less noise than the shortest.
  const double bias = longest < 2 ? 0.0 : judge.bias(std::max(1, h / 2), std::max(2, h), h);
  derived.bias = std::sqrt(std::max(0.0, bias)) / period_s;
  return derived;
}

}  // namespace farrier::diagnosis
