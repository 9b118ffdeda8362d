#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/noise.hpp"
#include "diagnosis/data/sample_statistics.hpp"
#include "diagnosis/judge/hypothesis.hpp"

namespace farrier::diagnosis {
namespace {

constexpr int kResamplings = 400;

}  // namespace

Gain Bench::gain(const Hypothesis& before, const Hypothesis& after) const {
  Gain gain{};
  std::size_t blocks = 0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    blocks = std::max(blocks, before.squares[c].size());
  }
  const auto over = [&](auto&& index_of, std::size_t count) {
    double sum = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (before.squares[c].empty()) {
        continue;
      }
      double was = 1e-300;
      double is = 1e-300;
      for (std::size_t i = 0; i < count; ++i) {
        was += before.squares[c][index_of(i)];
        is += after.squares[c][index_of(i)];
      }
      sum += 0.5 * std::log(was / is);
    }
    return sum;
  };
  gain.log_ratio = over([](std::size_t i) { return i; }, blocks);
  gain.by_half = {over([](std::size_t i) { return i; }, blocks / 2),
                  over([&](std::size_t i) { return blocks / 2 + i; }, blocks - blocks / 2)};
  for (std::size_t c = 0; c < kChannels; ++c) {
    const double was = before.total(c);
    gain.reduction[c] = was > 0.0 ? 1.0 - std::sqrt(after.total(c) / was) : 0.0;
  }
  const NoiseStream draws(1, "diagnosis", "bootstrap");
  std::vector<double> samples;
  for (int r = 0; r < kResamplings; ++r) {
    const auto drawn = [&](std::size_t i) {
      return static_cast<std::size_t>(draws.uniform(static_cast<Tick>(r) * 100000 + static_cast<Tick>(i)) *
                                      static_cast<double>(blocks));
    };
    samples.push_back(over(drawn, blocks));
  }
  std::ranges::sort(samples);
  gain.low = samples[kResamplings / 40];
  gain.high = samples[kResamplings - 1 - kResamplings / 40];
  gain.chance = static_cast<double>(std::ranges::count_if(samples, [](double s) { return s > 0.0; })) / kResamplings;
  return gain;
}

ErrorRatio Bench::error_ratio(const Hypothesis& before, const Hypothesis& after) const {
  std::size_t blocks = 0;
  std::array<double, kChannels> weight{};
  for (std::size_t c = 0; c < kChannels; ++c) {
    blocks = std::max(blocks, before.squares[c].size());
    if (fit_data_.judged[c]) {
      const std::vector<double>& values = simulator_.measured(static_cast<Channel>(c));
      const double deviation = standard_deviation(values);
      weight[c] = 1.0 / std::max(deviation * deviation * static_cast<double>(values.size()), 1e-300);
    }
  }
  const auto error = [&](const Hypothesis& hypothesis, const std::vector<std::size_t>& drawn) {
    double sum = 0.0;
    for (std::size_t c = 0; c < kChannels; ++c) {
      for (const std::size_t i : drawn) {
        sum += i < hypothesis.squares[c].size() ? weight[c] * hypothesis.squares[c][i] : 0.0;
      }
    }
    return std::sqrt(sum / static_cast<double>(std::ranges::count(fit_data_.judged, true)));
  };
  std::vector<std::size_t> drawn(blocks);
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  ErrorRatio ratio{error(before, drawn), error(after, drawn), 1.0, 1.0};
  const NoiseStream draws(1, "diagnosis", "ratio");
  std::vector<double> samples;
  for (int r = 0; r < kResamplings; ++r) {
    for (std::size_t i = 0; i < blocks; ++i) {
      const Tick number = static_cast<Tick>(r) * static_cast<Tick>(blocks) + static_cast<Tick>(i);
      drawn[i] = static_cast<std::size_t>(draws.uniform(number) * static_cast<double>(blocks));
    }
    samples.push_back(error(before, drawn) / std::max(error(after, drawn), 1e-300));
  }
  std::ranges::sort(samples);
  ratio.low = samples[kResamplings / 40];
  ratio.high = samples[kResamplings - 1 - kResamplings / 40];
  return ratio;
}

}  // namespace farrier::diagnosis
