#include "report/walk/walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace farrier::report {
namespace walk_test {

constexpr double kPeriod_s = 0.01;
constexpr double kHeight_m = 0.6;

WalkPlan plan() {
  return {.period_s = kPeriod_s,
          .forward_m_s = 0.5,
          .left_m_s = 0.0,
          .yaw_rate_rad_s = 0.0,
          .height_m = kHeight_m,
          .walk_s = 1.0,
          .normal = Eigen::Vector3d::UnitZ(),
          .plain = true};
}

/// Stands for a second, then moves with this velocity at this height.
std::vector<signals::BodyTruth> walk_of(double seconds, double forward_m_s, double left_m_s, double height_m) {
  std::vector<signals::BodyTruth> rows;
  for (Tick tick = 0; static_cast<double>(tick) * kPeriod_s < seconds; ++tick) {
    signals::BodyTruth row;
    row.tick = tick;
    const double since_s = std::max(0.0, static_cast<double>(tick) * kPeriod_s - 1.0);
    row.position_m = {forward_m_s * since_s, left_m_s * since_s, height_m};
    row.velocity_m_s = {forward_m_s, left_m_s, 0.0};
    row.attitude = {1.0, 0.0, 0.0, 0.0};
    row.foot_force_N[2] = 300.0;
    row.foot_force_N[3] = 400.0;
    row.foot_force_N[5] = 300.0;
    rows.push_back(row);
  }
  return rows;
}

TEST(Walk, OfASteadyTrunkHasTheFiguresOfItsMotion) {
  const WalkFigures walk = judge_walk(plan(), walk_of(11.0, 0.49, 0.02, kHeight_m + 0.004));
  EXPECT_FALSE(walk.fell_s);
  EXPECT_NEAR(walk.seconds, 6.0, 2 * kPeriod_s);
  EXPECT_NEAR(walk.way_m, 10.0 * std::hypot(0.49, 0.02), 0.02);
  EXPECT_NEAR(walk.height_rms_m, 0.0, 1e-9);
  EXPECT_NEAR(walk.height_offset_m, 0.004, 1e-9);
  EXPECT_NEAR(walk.speed_error, std::hypot(0.01, 0.02) / 0.5, 1e-9);
  EXPECT_NEAR(walk.lateral_drift_m_min, 1.2, 0.01);
  EXPECT_NEAR(walk.largest_foot_force_N, 500.0, 1e-9);
}

TEST(Walk, EndsWithAFallAndItsReason) {
  auto rows = walk_of(4.0, 0.5, 0.0, kHeight_m);
  for (std::size_t i = 300; i < rows.size(); ++i) {
    rows[i].attitude = {std::cos(0.5), std::sin(0.5), 0.0, 0.0};  // 1 rad about x
  }
  const WalkFigures walk = judge_walk(plan(), rows);
  ASSERT_TRUE(walk.fell_s);
  EXPECT_NEAR(*walk.fell_s, 3.0, 1e-9);
  EXPECT_EQ(walk_text(walk), "fell after 3 s: the trunk tilts by 57.3 degrees at a height of 0.6 m");
  Figures figures;
  add_walk(figures, plan(), walk);
  EXPECT_FALSE(figures.all_hold());
}

TEST(Walk, ThatIsTooSlowIsBeyondItsBoundOnLevelGroundAlone) {
  const WalkFigures walk = judge_walk(plan(), walk_of(11.0, 0.4, 0.0, kHeight_m));
  Figures level, uneven;
  add_walk(level, plan(), walk);
  EXPECT_FALSE(level.all_hold());
  WalkPlan blocks = plan();
  blocks.plain = false;
  add_walk(uneven, blocks, walk);
  EXPECT_TRUE(uneven.all_hold());
}

/// A leg that swings by plan and gains from tick 10, touches the ground at 50, and has gains of stance from 53.
TEST(GaitChanges, CountsWhatJointsWereToldAndHowLateItCame) {
  const robot::Robot hyq = robot::load_robot(FARRIER_ROBOTS "/hyq.yaml").value();
  std::vector<trace::TraceRow> rows;
  for (Tick tick = 0; tick < 100; ++tick) {
    for (const robot::Joint& joint : hyq.joints) {
      trace::TraceRow row{.tick = tick, .joint = joint.number};
      const bool leg = joint.leg == 0;
      row.phase = leg && tick >= 10 && tick < 53 ? Phase::kSwing : Phase::kStance;
      row.actual_phase = leg && tick >= 14 && tick < 50 ? Phase::kSwing : Phase::kStance;
      rows.push_back(row);
    }
  }
  std::vector<signals::GaitPhase> phases(3);
  phases[0] = {.leg = 0, .count = 1, .announced_tick = 0, .switch_tick = 10, .phase = Phase::kSwing};
  phases[1] = {.leg = 0, .count = 2, .announced_tick = 40, .switch_tick = 80, .phase = Phase::kStance};
  phases[2] = {.leg = 0, .count = 3, .announced_tick = 52, .switch_tick = 53, .phase = Phase::kStance, .felt = 1};
  const GaitChanges changes{phases, rows};
  Figures figures;
  add_gait_changes(figures, hyq, changes);
  const auto value = [&figures](const std::string& name) {
    return std::ranges::find(figures.all(), "trot.body." + name, &Figure::name)->value;
  };
  EXPECT_EQ(value("planned_switches"), 2.0);
  EXPECT_EQ(value("felt_switches"), 1.0);
  EXPECT_EQ(value("late_touchdowns"), 1.0);
  EXPECT_NEAR(value("mean_late_ms"), 3.0, 1e-9);
  EXPECT_NEAR(value("largest_late_ms"), 3.0, 1e-9);

  const std::vector<Panel> panels = gait_panels(hyq, changes, 0, 100);
  ASSERT_EQ(panels.size(), 4u);
  EXPECT_EQ(panels[0].y_label, "lf");
  // plan, contact and gains change where they should, and the felt touchdown is a point
  const auto changes_of = [](const Series& series) {
    std::vector<double> at_ms;
    for (std::size_t i = 1; i < series.y.size(); ++i) {
      if (series.y[i] != series.y[i - 1]) {
        at_ms.push_back(std::round(1e3 * series.x[i]));
      }
    }
    return at_ms;
  };
  EXPECT_EQ(changes_of(panels[0].series[0]), (std::vector<double>{10, 80}));
  EXPECT_EQ(changes_of(panels[0].series[1]), (std::vector<double>{14, 50}));
  EXPECT_EQ(changes_of(panels[0].series[2]), (std::vector<double>{10, 53}));
  ASSERT_EQ(panels[0].series[3].x.size(), 1u);
  EXPECT_NEAR(panels[0].series[3].x[0], 0.053, 1e-12);
  EXPECT_TRUE(changes_of(panels[1].series[2]).empty());
}

}  // namespace walk_test
}  // namespace farrier::report
