// Stance gains act before the planned touchdown, because a leg may land early.

#include <limits>

#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace stance_lead_test {

using namespace testing;
using signals::Phase;

constexpr Tick kLead = 10;
constexpr auto kStance = Phase::kStance;
constexpr auto kSwing = Phase::kSwing;

Bench early() {
  robot::Safety safety = hyq().safety;
  safety.stance_lead_s = kLead * hyq().period_s;
  return Bench::tracking(joint_named("lf_kfe"), safety);
}

TEST(StanceLead, ChangesToStanceBeforeTheAnnouncedTouchdown) {
  Bench bench = early();
  bench.announce(Phase::kSwing, 1, 5);
  bench.announce(Phase::kStance, 2, 45);
  EXPECT_EQ(bench.step_to(45 - kLead - 1).valve.phase, kSwing);
  const auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.phase, kStance);
  EXPECT_EQ(outputs.valve.generation, 2u);
  EXPECT_EQ(bench.step_to(60).valve.phase, kStance);
}

TEST(StanceLead, ChangesToSwingAtTheAnnouncedLiftOff) {
  Bench bench = early();
  bench.announce(Phase::kSwing, 1, 45);
  EXPECT_EQ(bench.step_to(44).valve.phase, kStance);
  EXPECT_EQ(bench.step().valve.phase, kSwing);
}

TEST(StanceLead, ChangesAtOnceWhenTheAnnouncementComesWithinTheLead) {
  for (const Tick late : {Tick{1}, kLead - 1, kLead + 20}) {
    Bench bench = early();
    bench.announce(Phase::kSwing, 1, 0);
    EXPECT_EQ(bench.step_to(30).valve.phase, kSwing);
    bench.announce(Phase::kStance, 2, 30 + kLead - late);
    EXPECT_EQ(bench.step().valve.phase, kStance) << late;
  }
}

TEST(StanceLead, DoesNotLetATouchdownOvertakeTheLiftOffBeforeIt) {
  Bench bench = early();
  bench.announce(Phase::kSwing, 1, 20);
  bench.announce(Phase::kStance, 2, 60);
  bench.announce(Phase::kSwing, 3, 100);
  for (Tick tick = 0; tick < 120; ++tick) {
    const bool swings = (tick >= 20 && tick < 60 - kLead) || tick >= 100;
    EXPECT_EQ(bench.step().valve.phase, swings ? kSwing : kStance) << "tick " << tick;
  }
}

TEST(StanceLead, TakesAnAnnouncementOfAnyTick) {
  for (const Tick tick : {std::numeric_limits<Tick>::min(), kNoTick, std::numeric_limits<Tick>::max()}) {
    Bench bench = early();
    bench.announce(Phase::kSwing, 1, 0);
    bench.step();
    bench.announce(Phase::kStance, 2, tick);
    EXPECT_EQ(bench.step().valve.phase, tick < 0 ? kStance : kSwing) << tick;
  }
}

TEST(StanceLead, OfTheShippedRobotsIsAsLongAsTouchdownsMayBeEarly) {
  for (const char* name : {"hyq", "fc1d", "fc1d_real"}) {
    const robot::Robot robot = robot::load_shipped(name);
    EXPECT_EQ(robot.safety.stance_lead_s, robot.plan.gait.touchdown_jitter_s) << name;
    EXPECT_GT(robot.safety.stance_lead_s, 0.0) << name;
  }
}

// A touchdown that is felt has a later number and an earlier tick than the one that is announced.
TEST(StanceLead, ChangesAtOnceWhenATouchdownIsFelt) {
  Bench bench = early();
  bench.announce(Phase::kSwing, 1, 20);
  bench.announce(Phase::kStance, 2, 100);
  EXPECT_EQ(bench.step_to(59).valve.phase, kSwing);
  bench.announce(Phase::kStance, 3, 60);
  bench.announce(Phase::kSwing, 4, 160);
  for (Tick tick = 60; tick < 160; ++tick) {
    const JointNode::Outputs outputs = bench.step();
    EXPECT_EQ(outputs.valve.phase, kStance) << tick;
    EXPECT_EQ(outputs.measurement.phase_count, 3u) << tick;
  }
  EXPECT_EQ(bench.step().valve.phase, kSwing);
}

// The announcement may come before or after the joint's own tick of the readings that it was felt in.
TEST(StanceLead, AFeltTouchdownActsFromTheTickOfItsAnnouncement) {
  Bench bench = early();
  bench.announce(Phase::kSwing, 1, 20);
  EXPECT_EQ(bench.step_to(58).valve.phase, kSwing);
  bench.node.announce_phase({.leg = static_cast<std::uint16_t>(bench.joint.leg),
                             .count = 2,
                             .announced_tick = 60,
                             .switch_tick = 60,
                             .phase = Phase::kStance,
                             .felt = 1});
  EXPECT_EQ(bench.step_to(59).valve.phase, kSwing);
  EXPECT_EQ(bench.step().valve.phase, kStance);
}

}  // namespace stance_lead_test
}  // namespace farrier::joint_node
