#include "lab/switching.hpp"

#include <cmath>

#include "scenario_run.hpp"

namespace farrier::scenario {
namespace {

constexpr std::uint8_t kSwing = 0;
constexpr std::uint8_t kStance = 1;
constexpr Tick kLanding = 50;
constexpr Tick kWindow = 30;
constexpr double kRounding = 1e-12;

/// Every joint of the robot lands once, with an error of its number in the window and of a thousand elsewhere.
std::vector<record::TraceRow> landing_rows(const robot::Robot& robot) {
  std::vector<record::TraceRow> rows;
  for (Tick tick = 0; tick < kLanding + 2 * kWindow; ++tick) {
    for (const robot::Joint& joint : robot.joints) {
      record::TraceRow row;
      row.tick = tick;
      row.joint = joint.number;
      row.phase = tick < kLanding + 7 ? kSwing : kStance;  // announced for later than it happens
      row.actual_phase = tick < kLanding ? kSwing : kStance;
      const bool within = tick >= kLanding && tick < kLanding + kWindow;
      row.force_N_or_Nm = within ? -static_cast<double>(joint.number) : 1000.0;
      rows.push_back(row);
    }
  }
  return rows;
}

TEST(TouchdownErrors, IntegrateOverTheWindowAfterTheActualTouchdown) {
  const robot::Robot robot = load("hyq");
  const auto errors = lab::touchdown_errors(robot, landing_rows(robot), 0);
  EXPECT_EQ(errors.touchdowns, 1);
  for (const robot::Joint& joint : robot.joints) {
    const double flexes = joint.index_in_leg == 0 ? 0.0 : 1.0;
    EXPECT_NEAR(errors.integral_Ns[joint.number], flexes * joint.number * lab::kTouchdownWindow_s, kRounding)
        << joint.name;
  }
}

TEST(TouchdownErrors, LeaveOutWhatCameTooEarlyAndWhatTheRunCutShort) {
  const robot::Robot robot = load("hyq");
  auto rows = landing_rows(robot);
  EXPECT_EQ(lab::touchdown_errors(robot, rows, kLanding + 1).touchdowns, 0);
  rows.resize(static_cast<std::size_t>(kLanding + kWindow - 1) * robot.joints.size());
  EXPECT_EQ(lab::touchdown_errors(robot, rows, 0).touchdowns, 0);
}

class Switching : public ::testing::Test {
 protected:
  static lab::InprocRun settings(supervisor::Design design) {
    lab::InprocRun run;
    run.ticks = 3000;
    run.design = design;
    return run;
  }
};

TEST_F(Switching, ChangesGainsWithoutABumpOfTheValve) {
  const robot::Robot robot = load("hyq");
  const Outcome outcome = run(robot, settings(supervisor::Design::kPhases));
  const double bump = lab::largest_bump(robot, outcome.rows, outcome.result.gains);
  EXPECT_LE(bump, kRounding);
  EXPECT_GT(bump, 0.0) << "no gain change was replayed";
  EXPECT_TRUE(std::isnan(lab::largest_bump(robot, outcome.rows, {}))) << "gains that nobody issued";
}

TEST_F(Switching, KeepsTheForceAfterTouchdownBetterThanSwingGainsThroughout) {
  const robot::Robot robot = load("hyq");
  const auto error = [&](supervisor::Design design) {
    const Outcome outcome = run(robot, settings(design));
    return lab::touchdown_errors(robot, outcome.rows, lab::ticks_of(1.5, robot));
  };
  const auto on = error(supervisor::Design::kPhases);
  const auto off = error(supervisor::Design::kSwing);
  ASSERT_GT(on.touchdowns, 0);
  for (const robot::Joint& joint : robot.joints) {
    if (joint.index_in_leg > 0) {
      EXPECT_LT(on.integral_Ns[joint.number], off.integral_Ns[joint.number]) << joint.name;
    }
  }
}

}  // namespace
}  // namespace farrier::scenario
