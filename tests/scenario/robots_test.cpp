// Robots of other kinds than HyQ, by their files alone: six legs, one leg, and joints with electric motors.

#include <algorithm>
#include <cmath>
#include <optional>

#include "gait/reference.hpp"
#include "gait/schedule.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::scenario {
namespace robots_test {

// Every leg's third stride, from which a run is judged, is over here.
constexpr Tick kTicks = 4000;
constexpr Tick kShort = 1000;
constexpr std::size_t kJointsOfALeg = 3;

run::InprocRun adaptive(Tick ticks) {
  run::InprocRun run;
  run.ticks = ticks;
  run.seed = 3;
  run.design = supervisor::Design::kAdaptive;
  return run;
}

std::ptrdiff_t updates_of(const Outcome& outcome, const robot::Joint& joint) {
  return std::ranges::count_if(outcome.result.decisions, [&](const signals::JointUpdateDecision& decision) {
    return decision.joint == joint.number && decision.verdict == signals::UpdateVerdict::kAccepted;
  });
}

class OtherRobot : public testing::TestWithParam<const char*> {};

TEST_P(OtherRobot, TrotsWithGainsThatAdapt) {
  const robot::Robot robot = load(GetParam());
  ASSERT_EQ(robot.bounds.stance_nrmse, 0.10);
  const Outcome outcome = run(robot, adaptive(kTicks));
  const report::Tracking tracking = report::track(robot, gait::Schedule(robot.plan, 3), outcome.rows, 0);
  for (const robot::Joint& joint : robot.joints) {
    const report::JointTracking& of_joint = tracking.joints.at(joint.number);
    EXPECT_GT(of_joint.stance.ticks, 400u) << joint.name;
    EXPECT_LE(of_joint.stance.nrmse, robot.bounds.stance_nrmse) << joint.name;
    EXPECT_EQ(of_joint.missed_ticks, 0u) << joint.name;
    EXPECT_FALSE(of_joint.tripped) << joint.name;
    if (joint.index_in_leg > 0) {
      EXPECT_GE(updates_of(outcome, joint), 1) << joint.name;
      EXPECT_GT(of_joint.travel_rad, 0.3) << joint.name << " does not walk";
    }
  }
}

TEST_P(OtherRobot, LeavesTheSameTraceHoweverItsJointsAreGrouped) {
  const robot::Robot robot = load(GetParam());
  run::InprocRun grouped = adaptive(kShort);
  const std::string per_leg = run(robot, grouped).trace;
  ASSERT_FALSE(per_leg.empty());
  grouped.grouping = run::Grouping::kPerJoint;
  EXPECT_TRUE(run(robot, grouped).trace == per_leg) << "per joint";
  grouped.grouping = run::Grouping::kOne;
  EXPECT_TRUE(run(robot, grouped).trace == per_leg) << "all in one";
}

INSTANTIATE_TEST_SUITE_P(Shipped, OtherRobot, testing::Values("hexapod", "electric_leg", "electric_quad", "hyl"),
                         [](const auto& robot) { return std::string(robot.param); });

// Share of the weight that all legs in stance carry together, as the reference plans it.
double carried_share(const robot::Robot& robot, const gait::Schedule& schedule, const gait::Reference& reference,
                     Tick tick) {
  double shares = 0.0;
  for (std::size_t leg = 0; leg < robot.plan.legs.size(); ++leg) {
    shares +=
        gait::load_share(schedule.stance_progress(static_cast<int>(leg), tick), robot.plan.gait.load_transfer_fraction);
  }
  return shares * reference.weight_per_share_N(tick) / robot.plan.body_weight_N;
}

TEST(Hexapod, StandsOnThreeLegsAtLeastAndTheyCarryItsWholeWeight) {
  const robot::Robot hexapod = load("hexapod");
  ASSERT_EQ(hexapod.joints.size(), 6 * kJointsOfALeg);
  const gait::Schedule schedule(hexapod.plan, 1);
  const gait::Reference reference(hexapod.plan);
  for (Tick tick = schedule.lead_in_ticks(); tick < 3000; ++tick) {
    int standing = 0;
    for (int leg = 0; leg < 6; ++leg) {
      standing += schedule.phase(leg, tick) == gait::Phase::kStance ? 1 : 0;
    }
    ASSERT_GE(standing, 3) << tick;
    // Strides are whole ticks, so that the tripods hand over to within a tick's slope of the smooth step.
    ASSERT_NEAR(carried_share(hexapod, schedule, reference, tick), 1.0, 0.05) << tick;
  }
}

// One leg after the other: no two offsets alike, five legs on the ground.
TEST(Hexapod, WalksInAWaveWhenItsOffsetsSaySo) {
  robot::Robot hexapod = load("hexapod");
  gait::GaitParams& gait = hexapod.plan.gait;
  gait.frequency_Hz = 0.5;
  gait.duty = 5.0 / 6.0;
  gait.step_length_m = 0.10;
  for (std::size_t leg = 0; leg < hexapod.plan.legs.size(); ++leg) {
    hexapod.plan.legs[leg].phase_offset = static_cast<double>(leg) / 6.0;
  }
  ASSERT_TRUE(gait::validate(hexapod.plan).ok());
  const Outcome outcome = run(hexapod, adaptive(3000));
  const report::Tracking tracking = report::track(hexapod, gait::Schedule(hexapod.plan, 3), outcome.rows, 0);
  for (const robot::Joint& joint : hexapod.joints) {
    EXPECT_FALSE(tracking.joints.at(joint.number).tripped) << joint.name;
  }
}

// Error of the knee in stance. The mass of its stance load grows fourfold in mid-run, and no message says so.
double knee_error_under_a_growing_load(const robot::Robot& leg, supervisor::Design design) {
  constexpr double kGrowth = 4.0;
  constexpr Tick kGrows = 3500;
  const robot::Joint& knee = leg.joints.at(kJointsOfALeg - 1);
  run::InprocRun settings = adaptive(2 * kGrows);
  settings.design = design;
  plant::LoadParams heavier = knee.stance_load;
  heavier.mass *= kGrowth;
  settings.load_changes.push_back({kGrows, knee.number, heavier});
  const Outcome outcome = run(leg, settings);
  const report::Tracking tracking = report::track(leg, gait::Schedule(leg.plan, settings.seed), outcome.rows, 0);
  return tracking.joints.at(knee.number).stance.nrmse;
}

TEST(ElectricLeg, HoldsItsKneeUnderAGrowingLoadOnlyWithGainsThatAdapt) {
  const robot::Robot leg = load("electric_leg");
  EXPECT_LE(knee_error_under_a_growing_load(leg, supervisor::Design::kAdaptive), leg.bounds.stance_nrmse);
  EXPECT_GT(knee_error_under_a_growing_load(leg, supervisor::Design::kSwing), leg.bounds.stance_nrmse);
}

TEST(ElectricLeg, LeavesNoPressuresInItsTraceAndNoPhysicsInItsGains) {
  const Outcome outcome = run(load("electric_leg"), adaptive(200));
  ASSERT_FALSE(outcome.rows.empty());
  for (const trace::TraceRow& row : outcome.rows) {
    ASSERT_EQ(row.pressure_a_Pa, 0.0);
    ASSERT_EQ(row.pressure_b_Pa, 0.0);
  }
  ASSERT_FALSE(outcome.result.gains.empty());
  EXPECT_TRUE(std::ranges::all_of(outcome.result.gains, [](const auto& gains) { return gains.has_physics == 0; }));
}

}  // namespace robots_test
}  // namespace farrier::scenario
