#include "diagnosis/judge/residual_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

#include <unsupported/Eigen/FFT>

#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

std::vector<double> centred(std::span<const double> values) {
  const double middle = mean(values);
  std::vector<double> out(values.begin(), values.end());
  for (double& value : out) {
    value -= middle;
  }
  return out;
}

double power(std::span<const double> values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

/// Correlation of a at i with b at i + lag, lag >= 0, as a share of both powers.
double correlation(std::span<const double> a, std::span<const double> b, std::size_t lag, double scale) {
  return lag < a.size() ? std::inner_product(a.begin(), a.end() - static_cast<std::ptrdiff_t>(lag),
                                             b.begin() + static_cast<std::ptrdiff_t>(lag), 0.0) *
                              scale
                        : 0.0;
}

}  // namespace

Dependence dependence(const char* driver, std::span<const double> values, std::span<const double> residual, int bins) {
  Dependence result{driver, {}, {}, {}, 0.0};
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return values[i]; });
  const double middle = mean(residual);
  double between = 0.0;
  double all = 1e-300;
  for (std::size_t bin = 0; bin < static_cast<std::size_t>(bins); ++bin) {
    const std::size_t first = bin * order.size() / static_cast<std::size_t>(bins);
    const std::size_t last = (bin + 1) * order.size() / static_cast<std::size_t>(bins);
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      sum += residual[order[i]];
      squares += residual[order[i]] * residual[order[i]];
    }
    const auto count = static_cast<double>(last - first);
    const double mean = sum / count;
    result.from.push_back(values[order[first]]);
    result.mean.push_back(mean);
    result.deviation.push_back(std::sqrt(std::max(0.0, squares / count - mean * mean)));
    between += count * (mean - middle) * (mean - middle);
    all += squares - 2.0 * middle * sum + count * middle * middle;
  }
  result.explained = between / all;
  return result;
}

double whiteness(std::span<const double> residual, int lags) {
  const auto r = centred(residual);
  const double scale = 1.0 / std::max(power(r), 1e-300);
  double most = 0.0;
  for (int lag = 1; lag <= lags; ++lag) {
    most = std::max(most, std::abs(correlation(r, r, static_cast<std::size_t>(lag), scale)));
  }
  return most * std::sqrt(static_cast<double>(r.size()));
}

double cross_correlation(std::span<const double> residual, std::span<const double> input, int lags) {
  const auto r = centred(residual);
  const auto u = centred(input);
  const double scale = 1.0 / std::max(std::sqrt(power(r) * power(u)), 1e-300);
  double most = 0.0;
  for (int lag = 0; lag <= lags; ++lag) {
    const auto at = static_cast<std::size_t>(lag);
    most = std::max({most, std::abs(correlation(r, u, at, scale)), std::abs(correlation(u, r, at, scale))});
  }
  return most * std::sqrt(static_cast<double>(r.size()));
}

std::vector<double> power_density(std::span<const double> residual, double period_s, int segment) {
  const auto n = static_cast<std::size_t>(segment);
  if (residual.size() < n) {
    return {};
  }
  std::vector<double> window(n);
  for (std::size_t i = 0; i < n; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
  }
  const double window_power = power(window);
  Eigen::FFT<double> fft;
  std::vector<double> density(n / 2 + 1, 0.0);
  int segments = 0;
  for (std::size_t from = 0; from + n <= residual.size(); from += n / 2, ++segments) {
    std::vector<double> piece = centred(residual.subspan(from, n));
    for (std::size_t i = 0; i < n; ++i) {
      piece[i] *= window[i];
    }
    std::vector<std::complex<double>> lines;
    fft.fwd(lines, piece);
    for (std::size_t i = 0; i < density.size(); ++i) {
      density[i] += 2.0 * std::norm(lines[i]) * period_s / window_power;
    }
  }
  for (double& value : density) {
    value /= segments;
  }
  return density;
}

}  // namespace farrier::diagnosis
