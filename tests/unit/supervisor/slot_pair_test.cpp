// Margins of new gains, and how fast a joint may change between its two.

#include "supervisor/slot_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "control/design/margins.hpp"
#include "supervisor/supervisor.hpp"
#include "estimates.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::supervisor {
namespace slot_pair_test {

using namespace testing;
using signals::JointModelEstimate;
using signals::JointUpdateDecision;
using signals::UpdateVerdict;

constexpr std::uint64_t kSession = 31;
constexpr int kLong = 1000;
constexpr int kAnyPhase = control::kNoDwell - 1;  // ticks: longer than any dwell time that is one

/// Insists on an estimate of a heavy cart beside a slot with gains `other`.
JointUpdateDecision decide(const robot::UpdateLogicParams& logic, const control::Gains& other, int shortest_phase_ticks,
                           bool dwelling = false) {
  SlotUpdate slot = slot_for(cart(20.0), logic);
  const JointModelEstimate heavy = estimate_of(model_of(cart(50.0)));
  JointUpdateDecision decision;
  for (int look = 0; look < kLong; ++look) {
    decision = slot.look(heavy, look, {other, shortest_phase_ticks, dwelling});
    if (verdict_of(decision) == UpdateVerdict::kAccepted) {
      break;
    }
  }
  return decision;
}

TEST(SlotPair, RecordsTheMarginsOfGainsThatAreAccepted) {
  const JointUpdateDecision accepted = decide(credulous(), gains_for(cart(20.0)), kAnyPhase);
  ASSERT_EQ(verdict_of(accepted), UpdateVerdict::kAccepted);
  const control::Gains fresh = gains_for(cart(50.0));
  const control::Margins margins = control::margins(fresh.model, fresh, kNoDelay);
  EXPECT_EQ(accepted.disk_margin, margins.disk);
  EXPECT_EQ(accepted.delay_margin_s, std::min(margins.delay_ticks * rig().period_s, kLongestDelay_s));
  EXPECT_GT(accepted.disk_margin, 0.0);
  EXPECT_GT(accepted.delay_margin_s, 0.0);
}

TEST(SlotPair, RefusesGainsWhoseMarginsAreBelowTheirBounds) {
  const JointUpdateDecision accepted = decide(credulous(), gains_for(cart(20.0)), kAnyPhase);
  robot::UpdateLogicParams cautious = credulous();
  cautious.disk_margin_min = 1.01 * accepted.disk_margin;
  EXPECT_EQ(verdict_of(decide(cautious, gains_for(cart(20.0)), kAnyPhase)), UpdateVerdict::kMarginTooSmall);
  cautious.disk_margin_min = 0.99 * accepted.disk_margin;
  EXPECT_EQ(verdict_of(decide(cautious, gains_for(cart(20.0)), kAnyPhase)), UpdateVerdict::kAccepted);
  cautious.delay_margin_min_s = 1.01 * accepted.delay_margin_s;
  EXPECT_EQ(verdict_of(decide(cautious, gains_for(cart(20.0)), kAnyPhase)), UpdateVerdict::kMarginTooSmall);
}

TEST(SlotPair, NeedsNoDwellTimeBetweenLoopsThatAreTheSame) {
  const control::Gains gains = gains_for(cart(20.0));
  EXPECT_EQ(dwell_ticks(gains, gains), 0);
}

TEST(SlotPair, RefusesGainsThatTheOtherSlotsAllowNoSwitchingWithButNotOnARobotThatStands) {
  control::Gains unstable = gains_for(cart(20.0));
  unstable.force *= 100.0;
  ASSERT_EQ(dwell_ticks(gains_for(cart(50.0)), unstable), control::kNoDwell);
  EXPECT_EQ(verdict_of(decide(credulous(), unstable, kAnyPhase)), UpdateVerdict::kDwellTooLong);
  EXPECT_EQ(verdict_of(decide(credulous(), unstable, control::kNoDwell)), UpdateVerdict::kAccepted);
}

TEST(SlotPair, DesignsNothingWhileTheLastGainsMustActForLonger) {
  EXPECT_EQ(verdict_of(decide(credulous(), gains_for(cart(20.0)), kAnyPhase, true)), UpdateVerdict::kDwelling);
}

// hyq.yaml: 1.4 Hz are 714 ticks, 0.65 of them 464 in stance; 250 less 10 of lead less 10 of jitter.
TEST(SlotPair, KnowsTheShortestTimeForWhichASlotActs) {
  EXPECT_EQ(shortest_phase_ticks(hyq()), 230);
  robot::Robot standing = hyq();
  standing.plan.gait.pattern = gait::Pattern::kStand;
  EXPECT_EQ(shortest_phase_ticks(standing), control::kNoDwell);
}

// A touchdown may be felt from half the swing of 250 ticks on.
TEST(SlotPair, KnowsThatAFeltTouchdownShortensASwing) {
  robot::Robot walking = hyq();
  walking.on_ground = true;
  EXPECT_EQ(shortest_phase_ticks(walking), 115);
  walking.locomotion->felt_touchdown.least_swing_s = 0.2;
  EXPECT_EQ(shortest_phase_ticks(walking), 190);
  walking.locomotion->felt_touchdown.on = false;
  EXPECT_EQ(shortest_phase_ticks(walking), 230);
}

TEST(SlotPair, LooksWithoutAllocation) {
  SlotUpdate slot = slot_for(cart(20.0), credulous());
  const control::Gains other = gains_for(cart(2.0));
  const JointModelEstimate heavy = estimate_of(model_of(cart(50.0)));
  int accepted = 0;
  const test::AllocationGuard guard;
  for (int look = 0; look < 20; ++look) {
    accepted += verdict_of(slot.look(heavy, look, {other, control::kNoDwell - 1, false})) == UpdateVerdict::kAccepted;
  }
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(accepted, 1);
}

TEST(SupervisorMargins, TellWithTheFirstGainsWhichOnesFallShort) {
  robot::Robot demanding = hyq();
  demanding.update_logic.disk_margin_min = 2.0;
  for (const Design design : {Design::kPhases, Design::kAdaptive}) {
    Supervisor supervisor = Supervisor::create(demanding, design, kNoDelay, kSession).value();
    constexpr Tick kFirst = 7;
    const Supervisor::Outputs& first = supervisor.step(kFirst);
    ASSERT_EQ(first.decisions.size(), 2 * hyq().joints.size());
    ASSERT_EQ(first.design_statuses.size(), first.decisions.size());
    for (std::size_t i = 0; i < first.decisions.size(); ++i) {
      EXPECT_EQ(verdict_of(first.decisions[i]), UpdateVerdict::kMarginTooSmall);
      EXPECT_EQ(first.decisions[i].tick, kFirst);
      EXPECT_EQ(first.decisions[i].joint, first.gains[i].joint);
      EXPECT_EQ(first.decisions[i].phase, first.gains[i].phase);
      EXPECT_EQ(first.decisions[i].generation, first.gains[i].generation) << "they act all the same";
    }
    Supervisor content = Supervisor::create(hyq(), design, kNoDelay, kSession).value();
    EXPECT_TRUE(content.step(kFirst).decisions.empty()) << "shipped robots' first gains are within the bounds";
  }
}

// Estimates of loads that come and go, shown to both slots of every joint: as many redesigns as there can be.
TEST(SupervisorDwell, IssuesNoGainsToAJointSoonerThanItsLastOnesMustAct) {
  Supervisor supervisor = Supervisor::create(hyq(), Design::kAdaptive, kNoDelay, kSession).value();
  supervisor.step(0);
  struct Issue {
    Tick tick;
    std::uint32_t dwell;
  };
  std::map<std::uint16_t, Issue> last;
  int again = 0;
  for (Tick tick = 1; tick < 3000; ++tick) {
    for (const robot::Joint& joint : hyq().joints) {
      const auto phase = static_cast<signals::Phase>(tick / 370 % 2);
      const plant::LoadParams& load = tick / 130 % 2 == 0 ? joint.swing_load : joint.stance_load;
      if (hyq().estimate_due(tick - 1)) {
        supervisor.take(estimate_of(robot::model_of(joint, load, hyq().period_s), joint.number, phase), tick);
      }
    }
    for (const JointUpdateDecision& decision : supervisor.step(tick).decisions) {
      if (verdict_of(decision) != UpdateVerdict::kAccepted) {
        continue;
      }
      if (last.contains(decision.joint)) {
        EXPECT_GE(tick - last[decision.joint].tick, static_cast<Tick>(last[decision.joint].dwell)) << decision.joint;
        ++again;
      }
      EXPECT_LE(static_cast<int>(decision.dwell_ticks), shortest_phase_ticks(hyq()));
      last[decision.joint] = {tick, decision.dwell_ticks};
    }
  }
  EXPECT_GT(again, 10) << "redesigns that could have come too soon";
}

}  // namespace slot_pair_test
}  // namespace farrier::supervisor
