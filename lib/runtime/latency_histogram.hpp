#pragma once

#include <array>
#include <cstdint>

#include "core/time.hpp"

namespace farrier::runtime {

/// Histogram of latencies with 16 bins per octave from 1 us to 1 s: fixed memory, a quantile is within 4.5 %.
class LatencyHistogram {
 public:
  void add(Nanoseconds latency) noexcept;

  /// Latency in s that the fraction `quantile` (0..1) of the samples does not exceed; 0 without samples.
  double quantile_s(double quantile) const noexcept;

  /// Quantiles 0.5, 0.99 and 0.999, and the largest latency exactly, in s.
  std::array<double, 4> summary_s() const noexcept;

  std::uint64_t count() const noexcept { return count_; }

 private:
  static constexpr int kBinsPerOctave = 16;
  static constexpr int kOctaves = 20;

  std::array<std::uint64_t, kBinsPerOctave * kOctaves> bins_{};
  std::uint64_t count_ = 0;
  Nanoseconds largest_{0};
};

}  // namespace farrier::runtime
