#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/noise.hpp"

namespace farrier {
namespace noise_test {

constexpr std::uint64_t kSeed = 20140901;
constexpr Tick kSamples = 100'000;
// An estimate from n samples strays from the truth by its standard deviation; five of them happen by chance once in
// two million tests, and with a fixed seed either always or never.
constexpr double kSigmas = 5.0;

double spread(double variance_of_one) { return kSigmas * std::sqrt(variance_of_one / static_cast<double>(kSamples)); }

double correlation(const NoiseStream& one, const NoiseStream& other, Tick lag) {
  double sum = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    sum += one.normal(tick) * other.normal(tick + lag);
  }
  return sum / static_cast<double>(kSamples);
}

// Vectors of the authors' page (Fowler, Noll, Vo), FNV-1a with 64 bits.
TEST(StableHash, GivesThePublishedValues) {
  EXPECT_EQ(stable_hash(""), 0xcbf29ce484222325ull);
  EXPECT_EQ(stable_hash("a"), 0xaf63dc4c8601ec8cull);
  EXPECT_EQ(stable_hash("foobar"), 0x85944171f73967e8ull);
}

TEST(NoiseStream, GivesTheSameNumberForATickWhateverWasDrawnBefore) {
  const NoiseStream forwards(kSeed, "lf_kfe", "force");
  const NoiseStream backwards(kSeed, "lf_kfe", "force");
  std::vector<double> drawn;
  for (Tick tick = 0; tick < 100; ++tick) {
    drawn.push_back(forwards.normal(tick));
    forwards.uniform(tick);
  }
  for (Tick tick = 99; tick >= 0; --tick) {
    EXPECT_EQ(backwards.normal(tick), drawn[static_cast<std::size_t>(tick)]) << "tick " << tick;
  }
}

TEST(NoiseStream, DependsOnSeedNameAndChannel) {
  const double one = NoiseStream(kSeed, "lf_kfe", "force").normal(7);
  EXPECT_NE(one, NoiseStream(kSeed + 1, "lf_kfe", "force").normal(7));
  EXPECT_NE(one, NoiseStream(kSeed, "rf_kfe", "force").normal(7));
  EXPECT_NE(one, NoiseStream(kSeed, "lf_kfe", "velocity").normal(7));
}

TEST(NoiseStream, IsNormalWithMeanZeroAndVarianceOne) {
  const NoiseStream stream(kSeed, "lf_kfe", "force");
  double sum = 0, squares = 0, fourth = 0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double x = stream.normal(tick);
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  const auto n = static_cast<double>(kSamples);
  EXPECT_NEAR(sum / n, 0.0, spread(1.0));      // var x = 1
  EXPECT_NEAR(squares / n, 1.0, spread(2.0));  // var x^2 = 3 - 1
  EXPECT_NEAR(fourth / n, 3.0, spread(96.0));  // var x^4 = 105 - 9
}

TEST(NoiseStream, IsUniformOverTheUnitInterval) {
  const NoiseStream stream(kSeed, "lf", "touchdown");
  constexpr int kBins = 20;
  std::vector<int> bins(kBins);
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double u = stream.uniform(tick);
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    ++bins[static_cast<std::size_t>(u * kBins)];
  }
  const double share = 1.0 / kBins;
  for (const int count : bins) {  // binomial
    EXPECT_NEAR(count / static_cast<double>(kSamples), share, spread(share * (1.0 - share)));
  }
}

TEST(NoiseStream, DiffersBetweenNamesWithoutCorrelation) {
  const NoiseStream one(kSeed, "lf_kfe", "force");
  const NoiseStream other(kSeed, "lf_hfe", "force");
  EXPECT_NEAR(correlation(one, other, 0), 0.0, spread(1.0));
}

TEST(NoiseStream, IsWhite) {
  const NoiseStream stream(kSeed, "lf_kfe", "force");
  for (const Tick lag : {1, 2, 3, 10}) {
    EXPECT_NEAR(correlation(stream, stream, lag), 0.0, spread(1.0)) << "lag " << lag;
  }
}

}  // namespace noise_test
}  // namespace farrier
