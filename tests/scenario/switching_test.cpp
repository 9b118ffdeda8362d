#include "trials/switching.hpp"

#include <cmath>
#include <numeric>

#include "robot/robot_builder.hpp"
#include "scenario_run.hpp"

namespace farrier::scenario {
namespace switching_test {

constexpr signals::Phase kSwing = signals::Phase::kSwing;
constexpr signals::Phase kStance = signals::Phase::kStance;
constexpr Tick kLanding = 50;
constexpr Tick kWindow = 30;
constexpr double kRounding = 1e-12;

/// Every joint of the robot lands once, with an error of its number in the window and of a thousand elsewhere.
std::vector<trace::TraceRow> landing_rows(const robot::Robot& robot) {
  std::vector<trace::TraceRow> rows;
  for (Tick tick = 0; tick < kLanding + 2 * kWindow; ++tick) {
    for (const robot::Joint& joint : robot.joints) {
      trace::TraceRow row;
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
  const auto errors = trials::touchdown_errors(robot, landing_rows(robot), 0);
  EXPECT_EQ(errors.touchdowns, 1);
  for (const robot::Joint& joint : robot.joints) {
    const double flexes = joint.index_in_leg == 0 ? 0.0 : 1.0;
    EXPECT_NEAR(errors.integral_Ns[joint.number], flexes * joint.number * trials::kTouchdownWindow_s, kRounding)
        << joint.name;
  }
}

TEST(TouchdownErrors, LeaveOutWhatCameTooEarlyAndWhatTheRunCutShort) {
  const robot::Robot robot = load("hyq");
  auto rows = landing_rows(robot);
  EXPECT_EQ(trials::touchdown_errors(robot, rows, kLanding + 1).touchdowns, 0);
  rows.resize(static_cast<std::size_t>(kLanding + kWindow - 1) * robot.joints.size());
  EXPECT_EQ(trials::touchdown_errors(robot, rows, 0).touchdowns, 0);
}

signals::JointControllerGains update(std::uint16_t joint, Phase phase, double k_force) {
  signals::JointControllerGains gains;
  gains.joint = joint;
  gains.phase = phase;
  gains.k_force = k_force;
  return gains;
}

TEST(LastGains, AreTheNewestOfEachSlot) {
  robot::Robot robot = load("hyq");
  robot.joints.erase(robot.joints.begin() + 2, robot.joints.end());
  const std::vector<signals::JointControllerGains> issued{
      update(0, kSwing, 1.0), update(0, kStance, 2.0), update(1, kSwing, 3.0),  update(1, kStance, 4.0),
      update(1, kSwing, 5.0), update(0, kStance, 6.0), update(0, kStance, 7.0),
  };
  const auto last = trials::last_gains(robot, issued);
  ASSERT_EQ(last.size(), 2u);
  EXPECT_EQ(last[0][kSwing].force, 1.0);
  EXPECT_EQ(last[0][kStance].force, 7.0);
  EXPECT_EQ(last[1][kSwing].force, 5.0);
  EXPECT_EQ(last[1][kStance].force, 4.0);
  const auto of_stance = trials::in_both_slots(last, signals::Phase::kStance);
  EXPECT_EQ(of_stance[0][kSwing].force, 7.0);
  EXPECT_EQ(of_stance[1][kStance].force, 4.0);
}

/// HyQ with the gains that a trot of the usual length adapted.
class Switching : public ::testing::Test {
 protected:
  static constexpr Tick kAdapting = 9000, kRun = 4000, kJudgedFrom = 1500;

  static void SetUpTestSuite() {
    run::InprocRun adaptive;
    adaptive.ticks = kAdapting;
    adaptive.design = supervisor::Design::kAdaptive;
    const robot::Robot robot = load("hyq");
    adapted_ = trials::last_gains(robot, run(robot, adaptive).result.gains);
  }
  static void TearDownTestSuite() { adapted_.clear(); }

  static Outcome run_with(const robot::Robot& robot, const std::vector<supervisor::SlotGains>& gains) {
    run::InprocRun settings;
    settings.ticks = kRun;
    settings.first_gains = gains;
    return run(robot, settings);
  }

  static trials::TouchdownErrors errors_with(const robot::Robot& robot,
                                             const std::vector<supervisor::SlotGains>& gains) {
    return trials::touchdown_errors(robot, run_with(robot, gains).rows, kJudgedFrom);
  }

  static robot::Robot undithered() {
    robot::Overrides overrides;
    overrides.without_dither = true;
    return load("hyq", overrides);
  }

  static std::vector<supervisor::SlotGains> adapted_;
};
std::vector<supervisor::SlotGains> Switching::adapted_;

TEST_F(Switching, ActsWithTheGainsThatWereGivenAndNoOthers) {
  const Outcome outcome = run_with(undithered(), adapted_);
  ASSERT_EQ(outcome.result.gains.size(), signals::kPhaseCount * adapted_.size());
  for (const signals::JointControllerGains& gains : outcome.result.gains) {
    EXPECT_EQ(gains.k_force, adapted_.at(gains.joint)[gains.phase].force);
  }
}

TEST_F(Switching, ChangesGainsWithoutABumpOfTheValve) {
  const robot::Robot robot = undithered();
  const Outcome outcome = run_with(robot, adapted_);
  const double bump = trials::largest_bump(robot, outcome.rows, outcome.result.gains);
  EXPECT_LE(bump, kRounding);
  EXPECT_GT(bump, 0.0) << "no gain change was replayed";
  EXPECT_TRUE(std::isnan(trials::largest_bump(robot, outcome.rows, {}))) << "gains that nobody issued";
}

TEST_F(Switching, KeepsTheForceAfterTouchdownBetterThanSwingGainsThroughout) {
  const robot::Robot robot = undithered();
  const auto on = errors_with(robot, adapted_);
  const auto off = errors_with(robot, trials::in_both_slots(adapted_, signals::Phase::kSwing));
  ASSERT_GT(on.touchdowns, 0);
  for (const robot::Joint& joint : robot.joints) {
    if (joint.index_in_leg > 0) {
      EXPECT_LT(on.integral_Ns[joint.number], off.integral_Ns[joint.number]) << joint.name;
    }
  }
}

TEST_F(Switching, HalvesTheForceErrorAfterTouchdownsWithAStepOfTheLoad) {
  constexpr double kAtMost = 0.5;  // of trot.switching.stepped_ratio
  robot::RobotFile file = undithered().file;
  file.gait.load_transfer_fraction = 0.0;
  const auto robot = robot::build_robot(std::move(file));
  ASSERT_TRUE(robot.ok());
  const auto sum = [](const trials::TouchdownErrors& errors) {
    return std::accumulate(errors.integral_Ns.begin(), errors.integral_Ns.end(), 0.0);
  };
  const auto on = errors_with(robot.value(), adapted_);
  const auto off = errors_with(robot.value(), trials::in_both_slots(adapted_, signals::Phase::kSwing));
  ASSERT_GT(on.touchdowns, 0);
  EXPECT_LE(sum(on), kAtMost * sum(off));
}

}  // namespace switching_test
}  // namespace farrier::scenario
