#include "diagnosis/wiring/box_regression.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::diagnosis {

void BoxRegression::add(double y, const Values& r) noexcept {
  ++points_;
  y_ += y;
  yy_ += y * y;
  for (std::size_t i = 0; i < count_; ++i) {
    r_[i] += r[i];
    ry_[i] += r[i] * y;
    for (std::size_t j = 0; j <= i; ++j) {
      rr_[i][j] += r[i] * r[j];
    }
  }
}

BoxRegression::Result BoxRegression::solve(const std::array<Bounds, kMost>& bounds) const noexcept {
  constexpr int kSweeps = 200;
  constexpr double kSettled = 1e-7;
  constexpr double kRounding = 1e-12;  // of the mean square: a constant varies by no more
  Result result;
  const double n = static_cast<double>(std::max<std::size_t>(points_, 1));
  const double variance = yy_ / n - y_ / n * (y_ / n);
  if (points_ == 0 || !(variance > 1e-12 * yy_ / n)) {
    for (std::size_t i = 0; i < count_; ++i) {
      result.coefficients[i] = std::clamp(0.0, bounds[i].low, bounds[i].high);
    }
    return result;
  }
  const double rms = std::sqrt(variance);
  Values along{};
  std::array<Values, kMost> gram{};
  std::array<bool, kMost> moves{};
  for (std::size_t i = 0; i < count_; ++i) {
    along[i] = ry_[i] / n - r_[i] / n * (y_ / n);
    for (std::size_t j = 0; j <= i; ++j) {
      gram[i][j] = gram[j][i] = rr_[i][j] / n - r_[i] / n * (r_[j] / n);
    }
    moves[i] = gram[i][i] > kRounding * rr_[i][i] / n;
    result.coefficients[i] = 0.5 * (bounds[i].low + bounds[i].high);
  }
  Values& c = result.coefficients;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double moved = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (!moves[i]) {
        c[i] = 0.0;  // a constant, which the regression has
        continue;
      }
      double rest = along[i];
      for (std::size_t j = 0; j < count_; ++j) {
        rest -= j == i ? 0.0 : gram[i][j] * c[j];
      }
      const double next = std::clamp(rest / gram[i][i], bounds[i].low, bounds[i].high);
      moved = std::max(moved, std::abs(next - c[i]) * std::sqrt(gram[i][i]));
      c[i] = next;
    }
    if (moved < kSettled * rms) {
      break;
    }
  }
  double left = variance;
  for (std::size_t i = 0; i < count_; ++i) {
    left -= 2.0 * c[i] * along[i];
    for (std::size_t j = 0; j < count_; ++j) {
      left += c[i] * c[j] * gram[i][j];
    }
  }
  result.unexplained = std::max(0.0, left / variance);
  return result;
}

}  // namespace farrier::diagnosis
