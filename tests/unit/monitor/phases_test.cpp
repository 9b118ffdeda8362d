// Phases of legs as they are told: announced ones, and touchdowns that are felt.

#include <gtest/gtest.h>

#include "feed.hpp"

namespace farrier::monitor {
namespace phases_test {

using namespace testing;

/// Announces to leg 1 at tick 100 its swing from tick 160 on, and its stance. Returns the latter.
signals::GaitPhase announce_step(Feed& feed, Tick stance_from) {
  signals::GaitPhase phase;
  phase.leg = 1;
  phase.announced_tick = 100;
  phase.switch_tick = 160;
  phase.phase = signals::Phase::kSwing;
  feed.take(phase);
  phase.switch_tick = stance_from;
  phase.phase = signals::Phase::kStance;
  feed.take(phase);
  return phase;
}

TEST(RobotView, SwitchesPhasesAtTheirTick) {
  Feed feed;
  feed.walk(0, 5);
  announce_step(feed, 400);
  EXPECT_EQ(feed.frame().phases[1], signals::Phase::kStance);
  feed.walk(100, 2);
  EXPECT_EQ(feed.frame().phases[1], signals::Phase::kStance);
  feed.walk(140, 1);
  EXPECT_EQ(feed.frame().phases[1], signals::Phase::kSwing);
  EXPECT_EQ(feed.frame().phases[0], signals::Phase::kStance);
  feed.walk(160, 12);
  EXPECT_EQ(feed.frame().phases[1], signals::Phase::kStance);
}

TEST(RobotView, TakesAFeltTouchdownBeforeTheAnnouncedOneAndCountsBoth) {
  Feed feed;
  feed.walk(0, 5);
  signals::GaitPhase phase = announce_step(feed, 600);
  feed.walk(180, 1);
  phase.announced_tick = phase.switch_tick = 400;
  phase.felt = 1;
  feed.take(phase);
  feed.walk(200, 12);
  const Frame frame = feed.frame();
  EXPECT_EQ(frame.phases[1], signals::Phase::kStance);
  EXPECT_EQ(frame.legs[1].planned_switches, 2u);
  EXPECT_EQ(frame.legs[1].felt_switches, 1u);
  EXPECT_EQ(frame.legs[0].planned_switches, 0u);
}

}  // namespace phases_test
}  // namespace farrier::monitor
