#include <chrono>
#include <limits>

#include "run.hpp"

namespace farrier::report {
namespace tracking_test {

using testing::hyq;
using testing::kSeed;
using testing::rows_of;

constexpr double kRounding = 1e-9;  // relative, of sums over some thousand ticks

struct Rehearsal {
  explicit Rehearsal(robot::Robot with = hyq()) : robot(std::move(with)), schedule(robot.plan, kSeed) {}

  Tick ticks() const { return schedule.lead_in_ticks() + 7 * schedule.stride_ticks(); }

  robot::Robot robot;
  gait::Schedule schedule;
};

robot::Robot standing() { return hyq({.pattern = gait::Pattern::kStand, .frequency_Hz = std::nullopt}); }

// A square wave of +-1 N from tick to tick has an RMS of 1 about its mean, up to the odd tick: 1/(2 n^2), n > 500.
constexpr double kOddTick = 1e-5;
double square_wave(Tick tick) { return tick % 2 == 0 ? 1.0 : -1.0; }

TEST(Tracking, ErrorIsRelativeToTheReferenceAboutItsMean) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    const double amplitude = 0.5 * rating_of(run.robot, joint).force;
    const double error = row.phase == gait::Phase::kStance ? 0.04 : 0.15;
    row.force_reference_N_or_Nm = amplitude * (3.0 + square_wave(row.tick));
    row.force_N_or_Nm = row.force_reference_N_or_Nm + amplitude * error;
  });
  for (const JointTracking& joint : track(run.robot, run.schedule, rows, 0).joints) {
    EXPECT_NEAR(joint.stance.nrmse, 0.04, 0.04 * kOddTick);
    EXPECT_NEAR(joint.swing.nrmse, 0.15, 0.15 * kOddTick);
  }
}

TEST(Tracking, JudgesPlannedPhasesWhicheverGainsActed) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    const bool stance = run.schedule.phase(joint.leg, row.tick) == gait::Phase::kStance;
    const double amplitude = 0.5 * rating_of(run.robot, joint).force;
    row.force_reference_N_or_Nm = amplitude * square_wave(row.tick);
    row.force_N_or_Nm = row.force_reference_N_or_Nm + amplitude * (stance ? 0.04 : 0.15);
    row.phase = run.schedule.phase(joint.leg, row.tick + 10);
    row.actual_phase = run.schedule.phase(joint.leg, row.tick - 7);
  });
  for (const JointTracking& joint : track(run.robot, run.schedule, rows, 0).joints) {
    EXPECT_NEAR(joint.stance.nrmse, 0.04, 0.04 * kOddTick);
    EXPECT_NEAR(joint.swing.nrmse, 0.15, 0.15 * kOddTick);
  }
}

TEST(Tracking, AReferenceAtRestIsMeasuredAgainstFivePercentOfTheRating) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    row.force_reference_N_or_Nm = 0.25 * rating_of(run.robot, joint).force;
    row.force_N_or_Nm = row.force_reference_N_or_Nm - 0.005 * rating_of(run.robot, joint).force;
  });
  for (const JointTracking& joint : track(run.robot, run.schedule, rows, 0).joints) {
    EXPECT_NEAR(joint.stance.nrmse, 0.1, kRounding);
  }
}

TEST(Tracking, RatingsAreThoseOfTheDataSheets) {
  const robot::Robot robot = hyq();
  EXPECT_DOUBLE_EQ(rating_of(robot, *robot.find("lf_kfe")).force, 3600.0);
  EXPECT_FALSE(rating_of(robot, *robot.find("lf_kfe")).rotary);
  EXPECT_DOUBLE_EQ(rating_of(robot, *robot.find("rh_haa")).force, 120.0);
  EXPECT_TRUE(rating_of(robot, *robot.find("rh_haa")).rotary);
}

TEST(Tracking, JudgesFromTheThirdStrideOfEachLeg) {
  const Rehearsal run;
  for (int leg = 0; leg < 4; ++leg) {
    const Tick first = first_judged_tick(run.robot, run.schedule, leg);
    EXPECT_EQ(run.schedule.stride(leg, first), 2);
    EXPECT_EQ(run.schedule.stride(leg, first - 1), 1);
  }
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    row.force_N_or_Nm = run.schedule.stride(joint.leg, row.tick) < 2 ? std::numeric_limits<double>::infinity() : 0.0;
  });
  for (const JointTracking& joint : track(run.robot, run.schedule, rows, 0).joints) {
    EXPECT_EQ(joint.stance.nrmse, 0.0);
  }
}

TEST(Tracking, ARobotThatStandsIsJudgedFromOneSecondAfterTheLeadIn) {
  const Rehearsal run(standing());
  EXPECT_EQ(first_judged_tick(run.robot, run.schedule, 0), run.schedule.lead_in_ticks() + 1000);
  const auto rows = rows_of(run.robot, run.schedule, 3000, [](const auto&, auto&) {});
  const Tracking tracking = track(run.robot, run.schedule, rows, 0);
  EXPECT_EQ(tracking.strides, 0);
  EXPECT_EQ(tracking.joints[0].stance.ticks, 3000u - 1000u - static_cast<unsigned>(run.schedule.lead_in_ticks()));
  EXPECT_EQ(tracking.joints[0].swing.ticks, 0u);
}

TEST(Tracking, TravelIsThatOfTheJointNotOfThePiston) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [](const auto&, auto&) {});
  for (const JointTracking& joint : track(run.robot, run.schedule, rows, 0).joints) {
    EXPECT_NEAR(joint.travel_rad, 0.5, 1e-4);  // sampled within half a tick of its peaks: 0.25 (2 pi f T)^2 / 8
  }
}

TEST(Tracking, CountsCommandsThatAreOlderThanTheLoopDelay) {
  const Rehearsal run;
  const Tick late = first_judged_tick(run.robot, run.schedule, 0) + 100;
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    row.command_age_ticks = joint.number == 0 && row.tick >= late && row.tick < late + 5 ? 2 : 1;
  });
  const Tracking tracking = track(run.robot, run.schedule, rows, 1);
  EXPECT_EQ(tracking.joints[0].missed_ticks, 5u);
  EXPECT_EQ(tracking.joints[1].missed_ticks, 0u);
}

TEST(Tracking, CountsTheStridesThatEveryLegCompleted) {
  const Rehearsal run;
  Tick ticks = 0;
  while (run.schedule.stride(0, ticks) < 4 || run.schedule.stride(1, ticks) < 4) {
    ++ticks;
  }
  EXPECT_EQ(track(run.robot, run.schedule, rows_of(run.robot, run.schedule, ticks, [](auto&, auto&) {}), 0).strides, 4);
  EXPECT_EQ(track(run.robot, run.schedule, rows_of(run.robot, run.schedule, ticks - 1, [](auto&, auto&) {}), 0).strides,
            3);
}

TEST(Tracking, AForceThatIsNotANumberFailsItsJointOnly) {
  const Rehearsal run;
  const Tick bad = first_judged_tick(run.robot, run.schedule, 0);
  const auto rows = rows_of(run.robot, run.schedule, run.ticks(), [&](const robot::Joint& joint, auto& row) {
    row.force_N_or_Nm = joint.number == 2 && row.tick == bad ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  });
  Figures figures;
  add_tracking(figures, run.robot, track(run.robot, run.schedule, rows, 0), Judgement::kLockstep);
  EXPECT_FALSE(figures.find("trot.lf_kfe.stance_nrmse")->holds());
  EXPECT_TRUE(figures.find("trot.lf_hfe.stance_nrmse")->holds());
}

TEST(Tracking, ARunTooShortToJudgeDoesNotPass) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, 100, [](const auto&, auto&) {});
  Figures figures;
  add_tracking(figures, run.robot, track(run.robot, run.schedule, rows, 0), Judgement::kLockstep);
  EXPECT_FALSE(figures.all_hold());
}

TEST(Tracking, OnlyKneesOfATrotMustTravel) {
  const auto bounded = [](const Rehearsal& run, const char* name) {
    Figures figures;
    add_tracking(figures, run.robot, track(run.robot, run.schedule, {}, 0), Judgement::kLockstep);
    return figures.find(name)->bound.has_value();
  };
  const Rehearsal trot;
  EXPECT_TRUE(bounded(trot, "trot.rh_kfe.travel_rad"));
  EXPECT_FALSE(bounded(trot, "trot.rh_hfe.travel_rad"));
  EXPECT_FALSE(bounded(Rehearsal(standing()), "trot.rh_kfe.travel_rad"));
}

TEST(Tracking, AJointThatIsItsPistonHasNoTravelInRadians) {
  auto rig = robot::load_robot(std::string(FARRIER_ROBOTS) + "/fc1d.yaml");
  ASSERT_TRUE(rig.ok()) << config::to_string(rig.error());
  const Rehearsal run(std::move(rig).value());
  Figures figures;
  add_tracking(figures, run.robot, track(run.robot, run.schedule, {}, 0), Judgement::kLockstep);
  EXPECT_EQ(figures.find("trot.fc1d.travel_rad"), nullptr);
  EXPECT_NE(figures.find("trot.fc1d.stance_nrmse"), nullptr);
}

TEST(Tracking, TakesWellUnderASecondForAHundredThousandRows) {
  const Rehearsal run;
  const auto rows = rows_of(run.robot, run.schedule, 100'000 / 12, [](const auto&, auto&) {});
  const auto start = std::chrono::steady_clock::now();
  const Tracking tracking = track(run.robot, run.schedule, rows, 0);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  RecordProperty("track_100k_rows_ms", std::to_string(taken.count() * 1e3));
  EXPECT_GT(tracking.ticks, 8000);
  EXPECT_LT(taken.count(), 0.5);
}

}  // namespace tracking_test
}  // namespace farrier::report
