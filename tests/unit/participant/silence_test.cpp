// When a stream counts as silent, and that each change is told once.

#include <gtest/gtest.h>

#include "participant/silence.hpp"

namespace farrier::participant {
namespace silence_test {

using namespace std::chrono_literals;
using enum EventKind;

constexpr SteadyTime kStart{std::chrono::hours(5)};

TEST(Silence, BeginsOnlyAfterTheFirstSample) {
  Silence silence(50ms, kEstimatesSilent, kEstimatesHeard);
  EXPECT_EQ(silence.look(kStart), std::nullopt);
  EXPECT_EQ(silence.look(kStart + 1h), std::nullopt);
  silence.heard(kStart + 1h);
  EXPECT_EQ(silence.look(kStart + 1h), std::nullopt);
  EXPECT_EQ(silence.look(kStart + 1h + 51ms), kEstimatesSilent);
}

TEST(Silence, IsToldOnceAndItsEndOnce) {
  Silence silence(50ms, kEstimatesSilent, kEstimatesHeard);
  silence.heard(kStart);
  EXPECT_EQ(silence.look(kStart + 50ms), std::nullopt);
  EXPECT_EQ(silence.look(kStart + 51ms), kEstimatesSilent);
  EXPECT_EQ(silence.look(kStart + 2s), std::nullopt);
  silence.heard(kStart + 2s);
  EXPECT_EQ(silence.look(kStart + 2s), kEstimatesHeard);
  EXPECT_EQ(silence.look(kStart + 2s + 10ms), std::nullopt);
}

TEST(Silence, IsNotReportedAfterAPauseOfTheListenerItself) {
  Silence silence(50ms, kEstimatesSilent, kEstimatesHeard);
  silence.heard(kStart);
  EXPECT_EQ(silence.look(kStart + 10ms), std::nullopt);
  silence.heard(kStart + 200ms);  // what waited is taken before it looks
  EXPECT_EQ(silence.look(kStart + 200ms), std::nullopt);
}

}  // namespace silence_test
}  // namespace farrier::participant
