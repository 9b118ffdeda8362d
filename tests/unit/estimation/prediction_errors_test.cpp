#include "estimation/prediction_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::estimation {
namespace prediction_errors_test {

constexpr int kSettled = 1000;  // 0.98^1000 = 2e-9 of the start is left
constexpr int kSeeds = 400;

/// e[k] = w[k] + share w[k - lag], w white.
PredictionErrors fed(std::uint64_t seed, double share, int lag = 1, double scale = 1.0) {
  const NoiseStream white(seed, "prediction", "error");
  PredictionErrors errors;
  for (Tick k = lag; k < lag + kSettled; ++k) {
    errors.take(scale * (white.normal(k) + share * white.normal(k - lag)));
  }
  return errors;
}

double rejected(double share, double level, int lag = 1) {
  int below = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    below += fed(seed, share, lag).whiteness() < level ? 1 : 0;
  }
  return static_cast<double>(below) / kSeeds;
}

// 400 seeds: a share of p has the standard error sqrt(p (1 - p) / 400). Autocorrelations under an exponential window
// have heavier tails than the distribution supposes, hence twice the level.
TEST(PredictionErrors, RejectWhiteErrorsAboutAsOftenAsTheLevelSays) {
  for (const double level : {0.05, 0.2, 0.5}) {
    const double error = std::sqrt(level * (1.0 - level) / kSeeds);
    EXPECT_LT(rejected(0.0, level), 2.0 * level) << level;
    EXPECT_GT(rejected(0.0, level), 0.5 * level - 3.0 * error) << level;
  }
}

TEST(PredictionErrors, RejectErrorsThatTheOnesBeforeThemTellOf) {
  constexpr double kLevel = 0.05;
  for (const int lag : {1, 2, 3, 4}) {
    EXPECT_GT(rejected(0.8, kLevel, lag), 0.95) << lag;  // r = 0.49: Q = 23.6 on average, where 9.5 rejects
  }
}

TEST(PredictionErrors, KnowVarianceAndAutocorrelationOfWhatTheyWereFed) {
  double variance = 0.0, first = 0.0, second = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const PredictionErrors errors = fed(seed, 0.5, 1, 3.0);
    variance += errors.variance() / kSeeds;
    first += errors.autocorrelation(1) / kSeeds;
    second += errors.autocorrelation(2) / kSeeds;
  }
  // Standard error of a mean of 400 windows of 99 samples: 0.005 relative to the variance; five of these, and what a
  // ratio of averages is biased by, 1 / 99.
  constexpr double kTolerance = 5.0 * 0.005 + 0.01;
  EXPECT_NEAR(variance / (9.0 * 1.25), 1.0, 2.0 * kTolerance);
  EXPECT_NEAR(first, 0.5 / 1.25, kTolerance);
  EXPECT_NEAR(second, 0.0, kTolerance);
}

TEST(PredictionErrors, AreJudgedWhateverTheirScale) {
  const double whiteness = fed(7, 0.3).whiteness();
  EXPECT_DOUBLE_EQ(fed(7, 0.3, 1, 1024.0).whiteness(), whiteness);
  EXPECT_DOUBLE_EQ(fed(7, 0.3, 1, 0x1p-40).whiteness(), whiteness);
}

TEST(PredictionErrors, AreWhiteUntilTheyHaveShownOtherwise) {
  PredictionErrors errors;
  EXPECT_EQ(errors.whiteness(), 1.0);
  EXPECT_EQ(errors.variance(), 0.0);
  errors.take(1.0);
  EXPECT_EQ(errors.whiteness(), 1.0);
}

TEST(PredictionErrors, CorrelateOnlyWhatFollowsTickByTick) {
  PredictionErrors errors;
  for (int k = 0; k < kSettled; ++k) {
    errors.take(1.0);
    errors.interrupt();
  }
  EXPECT_EQ(errors.autocorrelation(1), 0.0) << "no two errors were neighbours";
  for (int k = 0; k < kSettled; ++k) {
    errors.take(1.0);
  }
  EXPECT_NEAR(errors.autocorrelation(1), 1.0, 1e-6);
  EXPECT_LT(errors.whiteness(), 1e-30);
}

TEST(PredictionErrors, StayInTheirRangesWhateverComesAndAllocateNothing) {
  const test::AllocationGuard guard;
  for (const double bad :
       {1e40, 1e200, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    PredictionErrors errors;
    for (int k = 0; k < 20; ++k) {
      errors.take(k % 3 == 0 ? bad : 1.0);
      ASSERT_TRUE(errors.whiteness() >= 0.0 && errors.whiteness() <= 1.0) << bad << " at " << k;
    }
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace prediction_errors_test
}  // namespace farrier::estimation
