#include "gait/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/unit/gait/plan.hpp"

namespace farrier::gait {
namespace schedule_test {

constexpr std::uint64_t kSeed = 2014;
constexpr Tick kRun = 12000;
constexpr int kLegs = 4;

RobotPlan with_jitter(double jitter_s = 0.010) {
  RobotPlan plan = hyq_plan();
  plan.gait.touchdown_jitter_s = jitter_s;
  return plan;
}

std::vector<PhaseSwitch> announced(const Schedule& schedule, int leg) {
  std::vector<PhaseSwitch> all;
  for (Tick tick = 0; tick < kRun; ++tick) {
    if (const auto next = schedule.announcement(leg, tick)) {
      all.push_back(*next);
    }
  }
  return all;
}

TEST(Schedule, AllLegsStandThroughTheLeadIn) {
  const Schedule schedule(hyq_plan(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = 0; tick <= schedule.lead_in_ticks(); ++tick) {
      ASSERT_EQ(schedule.phase(leg, tick), Phase::kStance);
      ASSERT_EQ(schedule.stride(leg, tick), -1);
    }
  }
}

TEST(Schedule, RepeatsEveryStrideToTheTick) {
  const Schedule schedule(hyq_plan(), kSeed);
  const Tick settled = schedule.lead_in_ticks() + schedule.stride_ticks();
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = settled; tick < kRun; ++tick) {
      ASSERT_EQ(schedule.stance_progress(leg, tick), schedule.stance_progress(leg, tick + schedule.stride_ticks()));
    }
  }
}

TEST(Schedule, LegsAreOnTheGroundForTheDutyPartOfAStride) {
  const RobotPlan plan = hyq_plan();
  const Schedule schedule(plan, kSeed);
  const Tick begin = 3000;
  for (int leg = 0; leg < kLegs; ++leg) {
    int stance = 0;
    for (Tick tick = begin; tick < begin + schedule.stride_ticks(); ++tick) {
      stance += schedule.phase(leg, tick) == Phase::kStance ? 1 : 0;
    }
    EXPECT_NEAR(stance, plan.gait.duty * static_cast<double>(schedule.stride_ticks()), 0.5);  // rounded once
  }
}

TEST(Schedule, DiagonalLegsMoveTogetherAndTheDiagonalsHalfAStrideApart) {
  const Schedule schedule(hyq_plan(), kSeed);
  for (Tick tick = 0; tick < kRun; ++tick) {
    ASSERT_EQ(schedule.stance_progress(0, tick), schedule.stance_progress(3, tick));
    ASSERT_EQ(schedule.stance_progress(1, tick), schedule.stance_progress(2, tick));
    ASSERT_TRUE(schedule.phase(0, tick) == Phase::kStance || schedule.phase(1, tick) == Phase::kStance);
  }
  const Tick half = schedule.stride_ticks() / 2;
  for (Tick tick = 3000; tick < kRun; ++tick) {
    ASSERT_EQ(schedule.phase(0, tick), schedule.phase(1, tick + half));
  }
}

TEST(Schedule, ProgressRunsFromZeroToOneWithoutJumps) {
  const Schedule schedule(hyq_plan(), kSeed);
  const double largest_step = 1.0 / static_cast<double>(std::min(schedule.stance_ticks(), schedule.lead_in_ticks()));
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = 1; tick < kRun; ++tick) {
      const double before = schedule.stance_progress(leg, tick - 1);
      const double now = schedule.stance_progress(leg, tick);
      ASSERT_LT(now, 1.0);
      ASSERT_EQ(now < 0.0, schedule.phase(leg, tick) == Phase::kSwing);
      ASSERT_EQ(now < 0.0, schedule.swing_progress(leg, tick) >= 0.0);
      if (before >= 0.0 && now >= 0.0) {
        ASSERT_GE(now, before);
        ASSERT_LE(now - before, largest_step * (1.0 + 1e-9));
      } else if (before < 0.0 && now >= 0.0) {
        ASSERT_EQ(now, 0.0);
      }
    }
  }
}

TEST(Schedule, AnnouncesEverySwitchOnceInOrderAndAheadByTheAgreedTicks) {
  const RobotPlan plan = hyq_plan();
  const Schedule schedule(plan, kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    std::uint32_t count = 0;
    for (Tick tick = 0; tick < kRun; ++tick) {
      if (const auto next = schedule.announcement(leg, tick)) {
        ASSERT_EQ(next->count, ++count);
        ASSERT_EQ(next->tick, tick + plan.gait.announce_ticks);
        ASSERT_EQ(schedule.phase(leg, next->tick), next->phase);
        ASSERT_NE(schedule.phase(leg, next->tick - 1), next->phase);
      }
    }
    std::uint32_t switches = 0;
    for (Tick tick = 1; tick < kRun + plan.gait.announce_ticks; ++tick) {
      switches += schedule.phase(leg, tick) != schedule.phase(leg, tick - 1) ? 1 : 0;
    }
    EXPECT_EQ(count, switches);
  }
}

TEST(Schedule, AnnouncesAtOnceWhatComesTooSoonForNotice) {
  RobotPlan plan = hyq_plan();
  plan.gait.lead_in_s = 0.0;
  plan.gait.announce_ticks = 240;  // the first lift-off is at half a stance, 232 ticks
  const Schedule schedule(plan, kSeed);
  const auto first = schedule.announcement(1, 0);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->count, 1u);
  EXPECT_EQ(first->tick, 232);
  EXPECT_EQ(first->phase, Phase::kSwing);
  EXPECT_EQ(announced(schedule, 1)[1].count, 2u);
}

TEST(Schedule, TouchdownsComeWithinTheJitterOnEitherSideAndLiftOffsAsPlanned) {
  const Schedule schedule(with_jitter(), kSeed);
  std::set<Tick> shifts;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (std::uint32_t count = 1; count < 2000; ++count) {
      const PhaseSwitch planned{count, 1000 + count, count % 2 == 0 ? Phase::kStance : Phase::kSwing};
      const Tick shift = schedule.actual_switch(leg, planned) - planned.tick;
      if (planned.phase == Phase::kSwing) {
        ASSERT_EQ(shift, 0);
      } else {
        shifts.insert(shift);
      }
    }
  }
  EXPECT_EQ(*shifts.begin(), -10);
  EXPECT_EQ(*shifts.rbegin(), 10);
  EXPECT_EQ(shifts.size(), 21u);
}

TEST(Schedule, EverySwitchIsAnnouncedBeforeItHappens) {
  const Schedule schedule(with_jitter(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = 0; tick < kRun; ++tick) {
      if (const auto next = schedule.announcement(leg, tick)) {
        ASSERT_GE(schedule.actual_switch(leg, *next), tick + 2);
      }
    }
  }
}

TEST(Schedule, ActualPhasesChangeAtTheActualSwitches) {
  const Schedule schedule(with_jitter(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (const PhaseSwitch& planned : announced(schedule, leg)) {
      const Tick tick = schedule.actual_switch(leg, planned);
      ASSERT_EQ(schedule.actual_phase(leg, tick), planned.phase) << planned.count;
      ASSERT_NE(schedule.actual_phase(leg, tick - 1), planned.phase) << planned.count;
      if (planned.phase == Phase::kStance) {
        ASSERT_EQ(schedule.actual_stance_progress(leg, tick), 0.0);
      }
    }
  }
}

TEST(Schedule, AnActualStanceEndsWithThePlannedOneHoweverItBegan) {
  const Schedule schedule(with_jitter(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (const PhaseSwitch& planned : announced(schedule, leg)) {
      if (planned.phase == Phase::kStance) {
        const Tick lift_off = planned.tick + schedule.stance_ticks();
        const Tick touchdown = schedule.actual_switch(leg, planned);
        const double tick_share = 1.0 / static_cast<double>(lift_off - touchdown);
        ASSERT_NEAR(schedule.actual_stance_progress(leg, lift_off - 1), 1.0 - tick_share, 1e-12);
      }
    }
  }
}

TEST(Schedule, WithoutJitterTheActualPhaseIsThePlannedOne) {
  const Schedule schedule(hyq_plan(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = 0; tick < kRun; ++tick) {
      ASSERT_EQ(schedule.actual_stance_progress(leg, tick), schedule.stance_progress(leg, tick));
    }
  }
}

TEST(Schedule, TheSeedMovesTouchdownsAndNeverThePlan) {
  const Schedule one(with_jitter(), 1), same(with_jitter(), 1), other(with_jitter(), 2);
  int moved = 0;
  for (const PhaseSwitch& planned : announced(one, 0)) {
    EXPECT_EQ(one.actual_switch(0, planned), same.actual_switch(0, planned));
    moved += one.actual_switch(0, planned) != other.actual_switch(0, planned) ? 1 : 0;
  }
  EXPECT_GT(moved, 0);
  for (Tick tick = 0; tick < kRun; ++tick) {
    ASSERT_EQ(one.stance_progress(0, tick), other.stance_progress(0, tick));
  }
}

TEST(Schedule, StridesAreCountedFromTheFirstTouchdown) {
  const Schedule schedule(hyq_plan(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    int touchdowns = 0;
    for (Tick tick = 1; tick < kRun; ++tick) {
      touchdowns += schedule.stance_progress(leg, tick) == 0.0 ? 1 : 0;
      ASSERT_EQ(schedule.stride(leg, tick), touchdowns - 1);
    }
  }
}

TEST(Schedule, AStandingRobotNeverSwitches) {
  const Schedule schedule(hyq_standing(), kSeed);
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_TRUE(announced(schedule, leg).empty());
    EXPECT_EQ(schedule.stance_progress(leg, kRun), 0.5);
    EXPECT_EQ(schedule.actual_phase(leg, kRun), Phase::kStance);
    EXPECT_EQ(schedule.stride(leg, kRun), -1);
  }
}

}  // namespace schedule_test
}  // namespace farrier::gait
