#include <gtest/gtest.h>

#include <random>

#include "runtime/deadline.hpp"

namespace farrier::runtime {
namespace deadline_test {

using namespace std::chrono_literals;

constexpr Nanoseconds kPeriod = 1ms;
constexpr SteadyTime kStart{1000s};

TEST(NextDeadline, IsOnePeriodAfterThePreviousWhenInTime) {
  const Deadline deadline = next_deadline(kStart, kStart + 300us, kPeriod);
  EXPECT_EQ(deadline.next, kStart + kPeriod);
  EXPECT_EQ(deadline.missed, 0u);
}

TEST(NextDeadline, DoesNotDriftWithTheTimeOfTheCall) {
  EXPECT_EQ(next_deadline(kStart, kStart + 1us, kPeriod).next, next_deadline(kStart, kStart + 999us, kPeriod).next);
}

TEST(NextDeadline, SkipsAWholePeriodThatPassed) {
  const Deadline deadline = next_deadline(kStart, kStart + 1300us, kPeriod);
  EXPECT_EQ(deadline.next, kStart + 2ms);
  EXPECT_EQ(deadline.missed, 1u);
}

TEST(NextDeadline, SkipsManyPeriodsAtOnceInsteadOfCatchingUp) {
  const Deadline deadline = next_deadline(kStart, kStart + 5s + 1ns, kPeriod);
  EXPECT_EQ(deadline.next, kStart + 5001ms);
  EXPECT_EQ(deadline.missed, 5000u);
}

TEST(NextDeadline, LiesAfterNowEvenOnTheGrid) {
  const Deadline deadline = next_deadline(kStart, kStart + kPeriod, kPeriod);
  EXPECT_EQ(deadline.next, kStart + 2 * kPeriod);
  EXPECT_EQ(deadline.missed, 1u);
}

TEST(NextDeadline, ToleratesAClockReadBeforeThePreviousDeadline) {
  const Deadline deadline = next_deadline(kStart, kStart - 50us, kPeriod);
  EXPECT_EQ(deadline.next, kStart + kPeriod);
  EXPECT_EQ(deadline.missed, 0u);
}

// With any lateness the deadline is on the grid, after now and within a period of it. Every grid point is either woken
// up for or counted as missed.
TEST(NextDeadline, AccountsForEveryPeriodUnderRandomLateness) {
  std::mt19937_64 random(7);
  std::exponential_distribution<double> lateness_ms(0.7);
  SteadyTime previous = kStart;
  std::uint64_t woken = 0, missed = 0;
  for (int i = 0; i < 20'000; ++i) {
    const SteadyTime now = previous + Nanoseconds(static_cast<std::int64_t>(1e6 * lateness_ms(random)));
    const Deadline deadline = next_deadline(previous, now, kPeriod);
    ASSERT_GT(deadline.next, now);
    ASSERT_EQ((deadline.next - kStart) % kPeriod, 0ns);
    ASSERT_LE(deadline.next - now, kPeriod);
    ++woken;
    missed += deadline.missed;
    previous = deadline.next;
  }
  EXPECT_EQ(woken + missed, static_cast<std::uint64_t>((previous - kStart) / kPeriod));
  EXPECT_GT(missed, 0u);
}

TEST(SleepUntil, DoesNotWakeEarly) {
  const SteadyTime until = std::chrono::steady_clock::now() + 3ms;
  sleep_until(until);
  EXPECT_GE(std::chrono::steady_clock::now(), until);
}

}  // namespace deadline_test
}  // namespace farrier::runtime
