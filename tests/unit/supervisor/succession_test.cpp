// The choice of a leader among several supervisors, on a clock of the test's own.

#include "supervisor/succession.hpp"

#include <gtest/gtest.h>

namespace farrier::supervisor {
namespace succession_test {

using namespace std::chrono_literals;

SteadyTime at(Nanoseconds time) { return SteadyTime(1s + time); }

/// One that has followed authority 1 until `at(0)`.
Succession follower() {
  Succession standby(true);
  EXPECT_EQ(standby.step(1, at(0ms)), Duty::kNone);
  standby.heard(1, at(0ms));
  return standby;
}

TEST(Succession, FirstSupervisorOfARunLeadsAtOnce) {
  Succession first(false);
  EXPECT_EQ(first.step(0, at(0ms)), Duty::kNone);
  EXPECT_TRUE(first.leads());
  EXPECT_EQ(first.authority(), 1u);
}

TEST(Succession, StandbyDoesNotLeadARobotThatHasNoLeaderYet) {
  Succession standby(true);
  EXPECT_EQ(standby.step(0, at(0ms)), Duty::kNone);
  EXPECT_EQ(standby.step(0, at(10s)), Duty::kNone);
  EXPECT_FALSE(standby.leads());
}

TEST(Succession, StandbyFollowsAsLongAsModesCome) {
  Succession standby = follower();
  for (Nanoseconds time = 0ms; time < 1s; time += 19ms) {
    standby.heard(1, at(time));
    EXPECT_EQ(standby.step(1, at(time + 18ms)), Duty::kNone);
  }
  EXPECT_FALSE(standby.leads());
}

TEST(Succession, StandbyTakesOverUnderTheNextAuthorityAfterTheSilence) {
  Succession standby = follower();
  EXPECT_EQ(standby.step(1, at(20ms)), Duty::kNone);
  EXPECT_EQ(standby.step(1, at(21ms)), Duty::kTakeOver);
  EXPECT_TRUE(standby.leads());
  EXPECT_EQ(standby.authority(), 2u);
}

TEST(Succession, NewLeaderWritesAgainUntilEveryReaderHasNoticedTheSilence) {
  Succession standby = follower();
  ASSERT_EQ(standby.step(1, at(21ms)), Duty::kTakeOver);
  int rewrites = 0;
  Nanoseconds last = 0ms;
  for (Nanoseconds time = 22ms; time < 500ms; time += 1ms) {
    if (standby.step(2, at(time)) == Duty::kRewrite) {
      ++rewrites;
      last = time;
    }
  }
  EXPECT_EQ(rewrites, 5);
  EXPECT_GT(last, 21ms + Succession::kSilence) << "a reader may declare the old leader dead a lease later";
}

TEST(Succession, OneThatWasReplacedDuringAPauseStandsDown) {
  Succession stale(false);
  ASSERT_EQ(stale.step(0, at(0ms)), Duty::kNone);
  EXPECT_EQ(stale.step(2, at(300ms)), Duty::kStandDown);
  EXPECT_FALSE(stale.leads());
  stale.heard(2, at(305ms));
  EXPECT_EQ(stale.step(2, at(320ms)), Duty::kNone);
}

TEST(Succession, OneThatStoodDownLeadsAgainWhenItsSuccessorFallsSilent) {
  Succession stale(false);
  ASSERT_EQ(stale.step(0, at(0ms)), Duty::kNone);
  ASSERT_EQ(stale.step(2, at(300ms)), Duty::kStandDown);
  EXPECT_EQ(stale.step(2, at(321ms)), Duty::kTakeOver);
  EXPECT_EQ(stale.authority(), 3u);
}

TEST(Succession, LeaderWritesAgainWhenAReplacedOneIsHeard) {
  Succession standby = follower();
  ASSERT_EQ(standby.step(1, at(21ms)), Duty::kTakeOver);
  ASSERT_EQ(standby.step(2, at(200ms)), Duty::kNone);
  standby.heard(1, at(210ms));
  EXPECT_EQ(standby.step(2, at(211ms)), Duty::kRewrite);
}

TEST(Succession, FollowerDoesNotListenToAReplacedLeader) {
  Succession standby = follower();
  ASSERT_EQ(standby.step(2, at(5ms)), Duty::kNone);
  standby.heard(1, at(20ms));
  EXPECT_EQ(standby.step(2, at(26ms)), Duty::kTakeOver);
}

TEST(Succession, OneThatIsStartedAgainFollowsTheLeaderThereIs) {
  Succession again(false);
  EXPECT_EQ(again.step(2, at(0ms)), Duty::kNone);
  again.heard(2, at(4ms));
  EXPECT_EQ(again.step(2, at(20ms)), Duty::kNone);
  EXPECT_FALSE(again.leads());
}

TEST(Succession, OneThatIsStartedAgainLeadsARobotThatNobodyLeads) {
  Succession again(false);
  EXPECT_EQ(again.step(1, at(0ms)), Duty::kNone);
  EXPECT_EQ(again.step(1, at(21ms)), Duty::kTakeOver);
  EXPECT_EQ(again.authority(), 2u);
}

}  // namespace succession_test
}  // namespace farrier::supervisor
