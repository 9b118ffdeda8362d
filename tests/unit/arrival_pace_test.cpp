#include "recorder/arrival_pace.hpp"

#include <gtest/gtest.h>

namespace farrier::recorder {
namespace {

TEST(ArrivalPace, WaitsForEverySampleUntilItHasSeenATick) {
  ArrivalPace pace;
  EXPECT_EQ(pace.next(0, 0), 1u);
  EXPECT_EQ(pace.next(0, 7), 8u);
}

TEST(ArrivalPace, WakesAFewTimesATick) {
  ArrivalPace pace;
  pace.next(0, 0);
  EXPECT_EQ(pace.next(1, 48), 48u + 24u);
  std::uint64_t arrivals = 48;
  int wakes = 0;
  for (; arrivals < 96; ++wakes) {
    arrivals = pace.next(1, arrivals);
  }
  EXPECT_EQ(arrivals, 96u) << "the last of the tick wakes, not the first of the next";
  EXPECT_LE(wakes, 7);
  EXPECT_EQ(pace.next(1, 96), 97u);
}

TEST(ArrivalPace, TakesTheMeanOfTicksThatPassedTogether) {
  ArrivalPace pace;
  pace.next(1, 10);
  EXPECT_EQ(pace.next(5, 10 + 4 * 20), 90u + 10u);
}

TEST(ArrivalPace, KnowsNothingOfATickThatWentBack) {
  ArrivalPace pace;
  pace.next(9, 100);
  EXPECT_EQ(pace.next(1, 150), 151u);
}

}  // namespace
}  // namespace farrier::recorder
