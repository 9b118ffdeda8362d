#include "runtime/latency_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::runtime {

void LatencyHistogram::add(Nanoseconds latency) noexcept {
  const double microseconds = std::max(1.0, static_cast<double>(latency.count()) * 1e-3);
  const auto bin = static_cast<int>(std::log2(microseconds) * kBinsPerOctave);
  ++bins_[static_cast<std::size_t>(std::clamp(bin, 0, kBinsPerOctave * kOctaves - 1))];
  ++count_;
  largest_ = std::max(largest_, latency);
}

double LatencyHistogram::quantile_s(double quantile) const noexcept {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(quantile * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    seen += bins_[bin];
    if (seen >= wanted && seen > 0) {
      return 1e-6 * std::exp2((static_cast<double>(bin) + 0.5) / kBinsPerOctave);
    }
  }
  return 0;
}

std::array<double, 4> LatencyHistogram::summary_s() const noexcept {
  return {quantile_s(0.5), quantile_s(0.99), quantile_s(0.999), std::chrono::duration<double>(largest_).count()};
}

}  // namespace farrier::runtime
