#include "report/compare/load_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

#include "trace/force_error.hpp"
#include "supervisor/joint_design.hpp"
#include "supervisor/supervisor.hpp"
#include "tests/unit/report/run.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::report {
namespace {

constexpr double kRounding = 1e-12;
constexpr Tick kQuarter = 400;

const robot::Robot& rig() {
  static const robot::Robot robot =
      robot::load_robot(std::string(FARRIER_ROBOTS) + "/fc1d.yaml").value();
  return robot;
}

LoadCyclePlan plan() {
  LoadCyclePlan plan{rig(), {}, {}};
  for (std::size_t i = 0; i < plan.begin.size(); ++i) {
    plan.begin[i] = 100 + static_cast<Tick>(i) * kQuarter;
  }
  for (std::size_t i = 0; i < plan.loads.size(); ++i) {
    plan.loads[i] = i % 2 == 0 ? rig().joints[0].swing_load : rig().joints[0].stance_load;
  }
  return plan;
}

signals::JointControllerGains gains_at(Tick tick, std::uint32_t generation) {
  const robot::Joint& joint = rig().joints[0];
  auto signal = wire_gains::pack_gains(
      0, signals::Phase::kStance, 1, generation,
      supervisor::design_joint(joint, joint.swing_load, rig().period_s, 0).value());
  signal.effective_tick = tick;
  return signal;
}

/// A sine whose force lags by `error` of it, but not in the first 0.2 s of a quarter, where it is far off.
LoadCycleRun run_with(const std::string& name, double error) {
  LoadCycleRun run{name, name, {}, {gains_at(2, 1)}};
  const LoadCyclePlan of_run = plan();
  for (Tick tick = 0; tick < of_run.begin.back(); ++tick) {
    trace::TraceRow row;
    row.tick = tick;
    row.joint = 0;
    row.force_reference_N_or_Nm = 100.0 * std::sin(0.1 * static_cast<double>(tick));
    const bool transient = (tick - of_run.begin[0]) % kQuarter < 200;
    row.force_N_or_Nm = (transient ? 5.0 : 1.0 - error) * row.force_reference_N_or_Nm;
    run.rows.push_back(row);
  }
  return run;
}

Figures figures_with(double fixed, double adaptive, double true_load) {
  const std::vector<LoadCycleRun> runs{run_with("fixed", fixed), run_with("adaptive", adaptive),
                                       run_with("true_load", true_load), run_with("true_load_dithered", 0.08)};
  Figures figures;
  add_load_cycle(figures, plan(), runs);
  return figures;
}

TEST(RelativeError, IsThatOfTheTicksItIsAskedFor) {
  const LoadCycleRun run = run_with("fixed", 0.25);
  EXPECT_NEAR(trace::relative_error(run.rows, 300, 500), 0.25, kRounding);
  EXPECT_NEAR(trace::relative_error(run.rows, 100, 300), 4.0, kRounding);
  EXPECT_TRUE(std::isnan(trace::relative_error(run.rows, 5, 5)));
}

TEST(LoadCycleFigures, JudgeHeavyQuartersAfterTheTransientOfTheChange) {
  const Figures figures = figures_with(1.5, 0.07, 0.07);
  EXPECT_TRUE(figures.all_hold());
  for (const char* name : {"quarter1", "quarter2", "quarter3", "quarter4"}) {
    const bool heavy = name == std::string("quarter2") || name == std::string("quarter4");
    const Figure* fixed = figures.find("trot.fig7_8.fixed." + std::string(name) + "_nrmse");
    const Figure* adaptive = figures.find("trot.fig7_8.adaptive." + std::string(name) + "_nrmse");
    ASSERT_TRUE(fixed != nullptr && adaptive != nullptr);
    EXPECT_NEAR(fixed->value, 1.5, kRounding);
    EXPECT_NEAR(adaptive->value, 0.07, kRounding);
    EXPECT_EQ(fixed->bound.has_value(), heavy);
    EXPECT_EQ(adaptive->bound.has_value(), heavy);
  }
}

TEST(LoadCycleFigures, FailWhenAdaptingTracksNoBetterOrCostsTooMuchOrTheFixedGainsHold) {
  EXPECT_FALSE(figures_with(1.5, 0.09, 0.09).all_hold()) << "heavy quarters";
  EXPECT_FALSE(figures_with(1.5, 0.07, 0.06).all_hold()) << "light quarters";
  EXPECT_FALSE(figures_with(0.9, 0.07, 0.07).all_hold()) << "fixed gains";
}

TEST(LoadCycleFigures, CountTheUpdatesAfterTheFirstGains) {
  std::vector<LoadCycleRun> runs{run_with("adaptive", 0.07), run_with("true_load", 0.07),
                                 run_with("true_load_dithered", 0.07)};
  runs[0].gains = {gains_at(2, 1), gains_at(2, 2), gains_at(150, 3), gains_at(600, 4)};
  Figures figures;
  add_load_cycle(figures, plan(), runs);
  EXPECT_EQ(figures.find("trot.fig7_8.gain_updates")->value, 2.0);
}

TEST(LoadCycleReport, ShowsForcesGainsAndPolesOfEveryRun) {
  const std::string directory =
      (std::filesystem::temp_directory_path() / ("farrier_load_cycle_" + std::to_string(::getpid()))).string();
  const std::vector<LoadCycleRun> runs{run_with("fixed", 1.5), run_with("adaptive", 0.07)};
  Outcome outcome;
  outcome.command = "trot";
  const auto page = write_load_cycle_report(directory, outcome, plan(), runs);
  ASSERT_TRUE(page) << page.error().message;
  std::ostringstream html;
  html << std::ifstream(page.value()).rdbuf();
  for (const LoadCycleRun& run : runs) {
    for (const char* kind : {"_force.svg", "_poles.svg"}) {
      const std::string picture = "pictures/" + run.name + kind;
      EXPECT_NE(html.str().find(picture), std::string::npos) << picture;
      EXPECT_GT(std::filesystem::file_size(directory + "/" + picture), 1000u) << picture;
    }
  }
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace farrier::report
