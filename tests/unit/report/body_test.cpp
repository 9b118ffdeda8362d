#include "report/body/body_result.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "report/body/body_rows_file.hpp"
#include "report/body/energy_result.hpp"
#include "report/body/supply_result.hpp"

namespace farrier::report {
namespace body_test {

trials::TrotRow row(const std::string& trial, const std::string& name = "seed 1") {
  return {.trial = trial,
          .name = name,
          .figures = {.fell_s = std::nullopt,
                      .fall = {},
                      .height_rms_m = 0.002,
                      .height_offset_m = -0.001,
                      .sag_m = 0.003,
                      .tilt_rms_rad = 0.005,
                      .speed_error = 0.01,
                      .odometry_error = 0.001,
                      .heading_drift_rad_s = -1e-4,
                      .largest_torque_Nm = 120.0,
                      .hash = 0xfedcba9876543210ull},
          .failure = {}};
}

trials::TrotRow fallen(const std::string& trial) {
  trials::TrotRow of = row(trial, "fallen");
  of.figures.fell_s = 3.0;
  of.figures.fall = "tilt";
  of.figures.height_rms_m = 1.0;
  return of;
}

Figures figures_of(const std::vector<trials::TrotRow>& rows) {
  Figures figures;
  add_body(figures, body_results(rows));
  return figures;
}

TEST(BodyResult, IsTheWorstRunInTheUnitsOfItsFigures) {
  trials::TrotRow worse = row("flat", "seed 2");
  worse.figures.height_offset_m = -0.004;
  const Figures figures = figures_of({row("flat"), worse});
  EXPECT_EQ(figures.find("body.flat.runs")->value, 2.0);
  EXPECT_NEAR(figures.find("body.flat.height_offset_mm")->value, 4.0, 1e-12);
  EXPECT_NEAR(figures.find("body.flat.heading_drift_deg_min")->value, 0.3438, 1e-4);
  EXPECT_TRUE(figures.all_hold());
}

TEST(BodyResult, HasTheLargestLateralDriftPerMinute) {
  trials::TrotRow worse = row("flat", "seed 2");
  worse.figures.lateral_drift_m_s = -0.001;
  const Figures figures = figures_of({row("flat"), worse});
  EXPECT_NEAR(figures.find("body.flat.lateral_drift_m_min")->value, 0.06, 1e-12);
  worse.figures.lateral_drift_m_s = 0.004;
  EXPECT_FALSE(figures_of({worse}).find("body.flat.lateral_drift_m_min")->holds());
  EXPECT_EQ(figures_of({row("turning")}).find("body.turning.lateral_drift_m_min"), nullptr);
}

TEST(BodyResult, JudgesNoPushThatIsMadeToFall) {
  const std::vector<trials::TrotRow> rows{row("push_limit"), fallen("push_limit")};
  const Figures figures = figures_of(rows);
  EXPECT_TRUE(figures.all_hold());
  EXPECT_EQ(figures.find("body.push_limit.falls")->value, 1.0);
  EXPECT_EQ(figures.find("body.push_limit.height_rms_mm"), nullptr);
  EXPECT_EQ(falls_text(rows), "");
}

TEST(BodyResult, SaysUpToWhichImpulseTheLimitWasSearched) {
  const std::vector<trials::PushLimit> limits{{"behind", 232.5, 240.0}, {"left", 480.0, std::nullopt}};
  EXPECT_EQ(push_limits_text(limits),
            "pushes from behind: half fall at 240.0 Ns, fewer at 232.5 Ns\n"
            "pushes from left: fewer than half fall up to 480.0 Ns, the largest tried\n");
  Figures figures;
  add_push_limits(figures, limits);
  EXPECT_EQ(figures.find("body.push_limit.behind_Ns")->value, 240.0);
  EXPECT_EQ(figures.find("body.push_limit.left_Ns"), nullptr);
}

TEST(BodyResult, TellsInstantAndReasonOfEveryFall) {
  EXPECT_EQ(falls_text(std::vector{row("flat"), fallen("flat")}), "fell: flat, fallen, at 3.000 s: tilt\n");
}

TEST(BodyResult, FailsByOneFallOnTheFlat) {
  const Figures figures = figures_of({row("flat"), fallen("flat")});
  EXPECT_FALSE(figures.find("body.flat.falls")->holds());
  EXPECT_NEAR(figures.find("body.flat.height_rms_mm")->value, 2.0, 1e-12) << "a fall has no mean";
}

TEST(BodyResult, PassesWithOneFallInTwentyOverObstacles) {
  std::vector<trials::TrotRow> rows(19, row("step"));
  rows.push_back(fallen("step"));
  EXPECT_TRUE(figures_of(rows).all_hold());
  rows.push_back(fallen("step"));
  EXPECT_FALSE(figures_of(rows).all_hold());
}

TEST(BodyResult, BoundsMotionOnFlatGroundOnly) {
  trials::TrotRow wild = row("slopes");
  wild.figures.speed_error = 0.5;
  EXPECT_TRUE(figures_of({wild}).all_hold());
  wild.trial = "flat";
  EXPECT_FALSE(figures_of({wild}).all_hold());
}

TEST(BodyResult, ReportsTheLongLagWithoutABound) {
  const std::vector<trials::TrotRow> rows{fallen("long_lag")};
  const Figures figures = figures_of(rows);
  EXPECT_TRUE(figures.all_hold());
  EXPECT_EQ(figures.find("body.long_lag.height_rms_mm"), nullptr);
}

TEST(BodyText, HasALinePerTrialWithItsVerdict) {
  std::vector<trials::TrotRow> rows{row("flat"), fallen("pushes"), fallen("long_lag")};
  rows.front().figures.lateral_drift_m_s = -0.001;
  const std::string text = body_text(figures_of(rows), body_results(rows));
  EXPECT_EQ(text,
            "trial     runs  falls  height rms  offset  sag  tilt  speed  odometry  heading  drift  torque  verdict\n"
            "                       mm          mm      mm   deg   %      %         deg/min  m/min  Nm\n"
            "flat      1     0      2.0         1.0     3.0  0.29  1.00   0.10      0.34     0.06   120     pass\n"
            "pushes    1     1      -           -       -    -     -      -         -        -      120     fail\n"
            "long_lag  1     1      -           -       -    -     -      -         -        -      120     -\n");
}

class BodyRowsFile : public testing::Test {
 protected:
  ~BodyRowsFile() override { std::remove(path_.c_str()); }
  const std::string path_ = testing::TempDir() + "body_rows";
};

TEST_F(BodyRowsFile, GivesBackTheRunsOfItsOrigin) {
  ASSERT_TRUE(append_row(path_, "build 1", row("flat")).ok());
  ASSERT_TRUE(append_row(path_, "build 2", row("speed")).ok());
  trials::TrotRow turning = fallen("turning");
  turning.figures.odometry_error.reset();
  ASSERT_TRUE(append_row(path_, "build 1", turning).ok());
  std::ofstream(path_, std::ios::app) << "{\"trial\": \"fl";
  const std::vector<trials::TrotRow> rows = read_rows(path_, "build 1");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].name, "seed 1");
  EXPECT_EQ(rows[0].figures.hash, 0xfedcba9876543210ull);
  EXPECT_EQ(rows[0].figures.odometry_error, 0.001);
  EXPECT_EQ(rows[1].figures.fell_s, 3.0);
  EXPECT_FALSE(rows[1].figures.odometry_error.has_value());
}

TEST_F(BodyRowsFile, HasNoRunsWithoutAFile) { EXPECT_TRUE(read_rows(path_, "build 1").empty()); }

trials::TrotRow supply_row(const std::string& trial, const trials::SupplyFigures& supply) {
  trials::TrotRow of = row(trial);
  of.figures.supply = supply;
  return of;
}

TEST(SupplyResult, IsTheWorstRunOfATrial) {
  const std::vector<trials::TrotRow> rows{
      supply_row("low_supply", {.low_s = 1.0,
                                .sag_s = 2.0,
                                .slows_s = 0.5,
                                .largest_sinking_m_s = 0.1,
                                .largest_foot_force_N = 800.0,
                                .recovers = true,
                                .end_speed_m_s = 0.1}),
      supply_row("low_supply",
                 {.low_s = 3.0, .sag_s = 2.5, .acts_s = 3.3, .largest_sinking_m_s = 0.2, .end_speed_m_s = 0.2})};
  const auto results = supply_results(rows);
  Figures figures;
  add_supply(figures, results);
  EXPECT_EQ(figures.find("body.low_supply.low_s")->value, 3.0);
  EXPECT_EQ(figures.find("body.low_supply.sag_20mm_s")->value, 2.0);
  EXPECT_EQ(figures.find("body.low_supply.unnoticed_sags")->value, 1.0);
  EXPECT_FALSE(figures.find("body.low_supply.unnoticed_sags")->holds());
  EXPECT_EQ(figures.find("body.low_supply.lying_s"), nullptr);
  EXPECT_FALSE(figures.find("body.low_supply.acted")->holds()) << "it shall slow down";
  EXPECT_FALSE(figures.find("body.low_supply.not_recovered")->holds());
  EXPECT_EQ(
      supply_text(results),
      "low_supply: low after 3.00 s, 20 mm of sag after 2.00 s, slows after 0.50 s, locomotion acts after 3.30 s, "
      "lies never, sinks by at most 0.20 m/s, foot force at most 800 N, speed at the end 0.15 m/s\n");
}

trials::TrotRow energy_row(double work_J, double nrmse, int finer) {
  trials::TrotRow of = row("energy", std::to_string(finer));
  of.figures.energy = {.pump_J = 100.0, .relief_J = 60.0, .work_J = work_J};
  of.figures.force_nrmse[2][static_cast<std::size_t>(Phase::kStance)] = nrmse;
  of.figures.finer = finer;
  return of;
}

TEST(EnergyResult, HasTheMeansOfTermsAndTheChangesWithHalfTheStep) {
  const auto result = energy_result(
      std::vector<trials::TrotRow>{energy_row(38.0, 0.1, 1), energy_row(39.5, 0.1, 1), energy_row(0.0, 0.08, 2)});
  ASSERT_TRUE(result);
  Figures figures;
  add_energy(figures, *result);
  EXPECT_NEAR(figures.find("body.energy.work_J")->value, 38.75, 1e-12);
  EXPECT_NEAR(figures.find("body.energy.residual_percent")->value, 2.0, 1e-12) << "the largest";
  EXPECT_FALSE(figures.find("body.energy.residual_percent")->holds());
  EXPECT_NEAR(figures.find("body.energy.half_step.kfe_stance_nrmse_percent")->value, 20.0, 1e-9);
  EXPECT_FALSE(figures.find("body.energy.half_step.kfe_stance_nrmse_percent")->holds());
  EXPECT_TRUE(figures.find("body.energy.half_step.height_rms_percent")->holds());
  EXPECT_NE(energy_text(*result).find("relief valve"), std::string::npos);
}

TEST(EnergyResult, NeedsAPump) {
  EXPECT_FALSE(energy_result(std::vector<trials::TrotRow>{row("energy"), row("flat")}));
}

TEST(BodyRows, KeepWhatSupplyAndEnergyAre) {
  const std::string path = testing::TempDir() + "supply_rows";
  std::remove(path.c_str());
  trials::TrotRow of = energy_row(40.0, 0.1, 2);
  of.figures.way_m = 4.0;
  of.figures.supply = {
      .low_s = 1.5, .slows_s = 0.5, .largest_foot_force_N = 900.0, .recovers = true, .end_speed_m_s = 0.1};
  ASSERT_TRUE(append_row(path, "origin", of));
  const std::vector<trials::TrotRow> kept = read_rows(path, "origin");
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].figures.energy.work_J, 40.0);
  EXPECT_EQ(kept[0].figures.finer, 2);
  EXPECT_EQ(kept[0].figures.way_m, 4.0);
  EXPECT_EQ(kept[0].figures.supply->low_s, 1.5);
  EXPECT_EQ(kept[0].figures.supply->slows_s, 0.5);
  EXPECT_TRUE(kept[0].figures.supply->recovers);
  EXPECT_EQ(kept[0].figures.supply->end_speed_m_s, 0.1);
  EXPECT_FALSE(kept[0].figures.supply->lying_s);
}

TEST(SupplyResult, BoundsThatAWalkGoesOnAndThatARobotWithoutAPumpLies) {
  Figures figures;
  add_supply(figures, supply_results(std::vector<trials::TrotRow>{supply_row("supply", {.acts_s = 1.0}),
                                                                  supply_row("pump_stops", {.acts_s = 0.1})}));
  EXPECT_FALSE(figures.find("body.supply.acted")->holds());
  EXPECT_FALSE(figures.find("body.supply.not_lying")->bound.has_value());
  EXPECT_FALSE(figures.find("body.pump_stops.not_lying")->holds());
  EXPECT_TRUE(supply_results(std::vector<trials::TrotRow>{row("flat")}).empty());
}

TEST(SupplyResult, AllowsOneHardLandingOfEight) {
  const auto judged = [](int falls, int soft, double sinking_m_s) {
    std::vector<trials::TrotRow> rows;
    for (int run = 0; run < falls + soft; ++run) {
      rows.push_back(supply_row("dead_joint", {.acts_s = 0.1, .lying_s = 1.0, .largest_sinking_m_s = sinking_m_s}));
      if (run < falls) {
        rows.back().figures.fell_s = 15.0;
      }
    }
    Figures figures;
    add_supply(figures, supply_results(rows));
    return figures.find("body.dead_joint.hard_landings")->holds();
  };
  EXPECT_TRUE(judged(0, 1, 0.4));
  EXPECT_FALSE(judged(0, 1, 0.5));
  EXPECT_TRUE(judged(1, 7, 0.4));
  EXPECT_FALSE(judged(2, 6, 0.4));
}

}  // namespace body_test
}  // namespace farrier::report
