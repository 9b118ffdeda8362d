// When a sample would have come: the receiver's clock alone, whatever the sender's says.

#include <gtest/gtest.h>

#include <limits>

#include "participant/arrival.hpp"

namespace farrier::participant {
namespace arrival_test {

using namespace std::chrono_literals;

constexpr SteadyTime kStart{std::chrono::hours(5)};
constexpr std::int64_t kSendersStart_ns = 17'000'000;  // its clock began long after ours

/// Sends tick `tick` at its time and has it come `way` later.
class Sender {
 public:
  explicit Sender(Arrival& arrival) : arrival_(arrival) {}

  /// Returns how late the sample is held to be; nothing if it is not taken.
  std::optional<Nanoseconds> late(Tick tick, Nanoseconds way, Nanoseconds drift = 0ns) {
    const SteadyTime came = kStart + tick * 1ms + way;
    const auto at = arrival_.take(tick, kSendersStart_ns + (tick * 1ms + drift).count(), came);
    return at ? std::optional(came - *at) : std::nullopt;
  }

 private:
  Arrival& arrival_;
};

TEST(Arrival, TakesTheShortestDelayForTheUndisturbedOne) {
  Arrival arrival;
  Sender sender(arrival);
  EXPECT_EQ(sender.late(0, 300us), 0us);
  EXPECT_EQ(sender.late(1, 200us), 0us);
  EXPECT_EQ(sender.late(2, 6200us), 6000us - 100ns * 7);  // the drift that 7 ms allow
  EXPECT_LE(*sender.late(7, 1200us), 1000us);
}

TEST(Arrival, TakesNoSampleThatIsNotNewer) {
  Arrival arrival;
  Sender sender(arrival);
  EXPECT_TRUE(sender.late(5, 100us));
  EXPECT_FALSE(sender.late(5, 200us));
  EXPECT_FALSE(sender.late(4, 1300us));
  EXPECT_TRUE(sender.late(6, 100us));
}

TEST(Arrival, TakesASenderThatRestartedAfterASilence) {
  Arrival arrival;
  Sender sender(arrival);
  EXPECT_TRUE(sender.late(5000, 100us));
  // Tick 0 of the new one, 101 ms after the last.
  EXPECT_EQ(arrival.take(0, 123, kStart + 5101ms + 100us), kStart + 5101ms + 100us);
  EXPECT_TRUE(arrival.take(1, 1'000'123, kStart + 5102ms + 100us));
}

TEST(Arrival, HoldsForLateWhatWaitedThroughASilence) {
  Arrival arrival;
  Sender sender(arrival);
  for (Tick tick = 0; tick < 10; ++tick) {
    sender.late(tick, 200us);
  }
  // Either of the two was stopped for 0.15 s: the first sample that comes is as old as that, the next is not.
  EXPECT_GT(*sender.late(10, 150ms), 149ms);
  EXPECT_LT(*sender.late(161, 250us), 100us);
}

TEST(Arrival, TakesNoTickThatNoSenderCanHaveGotTo) {
  Arrival arrival;
  Sender sender(arrival);
  constexpr Tick kLast = std::numeric_limits<Tick>::max();
  EXPECT_TRUE(sender.late(5, 100us));
  for (const Tick tick : {kLast, kLast - 1, Tick{-2}, std::numeric_limits<Tick>::min(), 6 + Sequence::kFarthest}) {
    EXPECT_FALSE(arrival.take(tick, kSendersStart_ns + 6'000'000, kStart + 6ms)) << tick;
  }
  EXPECT_EQ(sender.late(6, 100us), 0us) << "the next right one must count";
}

TEST(Arrival, OneWrongStampMakesNoLaterSampleLate) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t kEnds[] = {-kMost - 1, -1, kMost, kMost / 4, kSendersStart_ns + 1'000'000'000};
  for (const std::int64_t wrong_ns : kEnds) {
    Arrival arrival;
    Sender sender(arrival);
    EXPECT_TRUE(sender.late(0, 100us));
    EXPECT_FALSE(arrival.take(1, wrong_ns, kStart + 1ms)) << wrong_ns;
    EXPECT_EQ(sender.late(2, 100us), 0us) << wrong_ns;
  }
}

TEST(Arrival, RecoversFromAWrongStampThatCameFirst) {
  Arrival arrival;
  Sender sender(arrival);
  EXPECT_TRUE(arrival.take(0, std::numeric_limits<std::int64_t>::max() / 8, kStart));
  EXPECT_GT(*sender.late(1, 100us), Arrival::kLongest);
  EXPECT_EQ(sender.late(2, 100us), 0us);
}

TEST(Sequence, IsNewAgainAfterASilenceAndNotBefore) {
  Sequence ticks;
  EXPECT_TRUE(ticks.take(7, kStart));
  EXPECT_FALSE(ticks.take(0, kStart + Sequence::kRestart));
  EXPECT_FALSE(ticks.take(7, kStart + 2 * Sequence::kRestart)) << "the same sample once more is none";
  EXPECT_TRUE(ticks.take(0, kStart + 2 * Sequence::kRestart));
  EXPECT_EQ(ticks.newest(), 0);
}

TEST(Arrival, FollowsAClockThatDriftsAway) {
  Arrival arrival;
  Sender sender(arrival);
  Nanoseconds latest{};
  for (Tick tick = 0; tick < 600'000; ++tick) {
    const Nanoseconds slower = -50ns * tick;  // 50 ppm: 30 ms in ten minutes
    latest = std::max(latest, *sender.late(tick, 150us, slower));
  }
  EXPECT_LT(latest, 1us);
}

}  // namespace arrival_test
}  // namespace farrier::participant
