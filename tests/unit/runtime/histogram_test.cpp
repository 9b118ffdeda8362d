#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "runtime/latency_histogram.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::runtime {
namespace histogram_test {

using namespace std::chrono_literals;

// The error that the class states. The middle of the right bin can be off by half a bin, 2^(1/32) - 1 = 2.2 %.
constexpr double kStatedError = 0.045;

TEST(LatencyHistogram, IsZeroWithoutSamples) {
  const LatencyHistogram histogram;
  EXPECT_EQ(histogram.count(), 0u);
  EXPECT_EQ(histogram.quantile_s(0.5), 0.0);
}

TEST(LatencyHistogram, GivesASingleLatencyAtEveryQuantile) {
  LatencyHistogram histogram;
  histogram.add(420us);
  for (const double quantile : {0.0, 0.5, 0.99, 1.0}) {
    EXPECT_NEAR(histogram.quantile_s(quantile), 420e-6, kStatedError * 420e-6) << quantile;
  }
}

TEST(LatencyHistogram, StaysWithinItsStatedErrorOfTheSortedSamples) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(std::log(2e-6), std::log(0.5));
  LatencyHistogram histogram;
  std::vector<double> latencies_s;
  for (int i = 0; i < 10'000; ++i) {
    const Nanoseconds latency(static_cast<std::int64_t>(1e9 * std::exp(exponent(random))));
    latencies_s.push_back(static_cast<double>(latency.count()) * 1e-9);
    histogram.add(latency);
  }
  std::sort(latencies_s.begin(), latencies_s.end());
  for (const double quantile : {0.001, 0.01, 0.25, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    // The smallest sample that at least this fraction does not exceed.
    const auto rank = static_cast<std::size_t>(std::ceil(quantile * static_cast<double>(latencies_s.size())));
    const double exact_s = latencies_s[rank - 1];
    EXPECT_NEAR(histogram.quantile_s(quantile), exact_s, kStatedError * exact_s) << "quantile " << quantile;
  }
}

TEST(LatencyHistogram, KeepsWhatIsOutsideItsRangeAtTheEnds) {
  LatencyHistogram histogram;
  histogram.add(-5us);  // clocks of two threads may disagree
  histogram.add(0ns);
  histogram.add(3600s);
  EXPECT_EQ(histogram.count(), 3u);
  EXPECT_NEAR(histogram.quantile_s(0.5), 1e-6, kStatedError * 1e-6);
  EXPECT_GE(histogram.quantile_s(1.0), 1.0);
}

TEST(LatencyHistogram, DoesNotAllocate) {
  LatencyHistogram histogram;
  const test::AllocationGuard guard;
  for (int i = 0; i < 1000; ++i) {
    histogram.add(Nanoseconds(i * i * 100));
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace histogram_test
}  // namespace farrier::runtime
