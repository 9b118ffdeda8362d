// The four update logics on the load cycle.

#include "trials/update_logic_study.hpp"

#include "trials/load_cycle.hpp"
#include "scenario_run.hpp"

namespace farrier::scenario {
namespace update_logic_test {

constexpr double kShortQuarter_s = 0.4;  // the transient and as much again

trials::UpdateLogicRun run_by(robot::UpdateMethod method) {
  const trials::LoadCycle cycle = trials::make_load_cycle(load("fc1d"), kShortQuarter_s).value();
  run::InprocRun settings;
  settings.ticks = cycle.begin.back();
  settings.load_changes = cycle.changes;
  auto run = trials::run_update_logic(cycle.robot, method, settings);
  EXPECT_TRUE(run.ok()) << (run ? "" : run.error().message);
  return run ? std::move(run).value() : trials::UpdateLogicRun{};
}

TEST(UpdateLogics, DoInTheReplayWhatTheyDidInTheRun) {
  for (const robot::UpdateMethod method : trials::kUpdateMethods) {
    const trials::UpdateLogicRun run = run_by(method);
    EXPECT_EQ(run.accepted + signals::kPhaseCount, run.result.gains.size()) << robot::to_string(method);
    EXPECT_GE(run.designs, run.accepted) << robot::to_string(method);
    EXPECT_GE(run.looks, run.designs) << robot::to_string(method);
    // Every estimate but the one of the last tick, on which nothing acts any more.
    EXPECT_NEAR(static_cast<double>(run.looks), static_cast<double>(run.rows.size()) / 10.0, 1.0);
  }
}

// Hubacher (2014), Section 5.3.1: (d) minimises the computational burden, (a) designs for every estimate.
TEST(UpdateLogics, DesignFewestControllersByDistinctPolesAndMostByLimits) {
  const std::uint64_t limits = run_by(robot::UpdateMethod::kLimits).designs;
  const std::uint64_t small_error = run_by(robot::UpdateMethod::kSmallError).designs;
  const std::uint64_t distinct = run_by(robot::UpdateMethod::kDistinctPoles).designs;
  EXPECT_LT(distinct, small_error);
  EXPECT_LE(small_error, limits);
}

TEST(UpdateLogics, AreDistinctPolesUnlessAFileSaysOtherwise) {
  const trials::LoadCycle cycle = trials::make_load_cycle(load("fc1d"), kShortQuarter_s).value();
  run::InprocRun settings;
  settings.ticks = cycle.begin.back();
  settings.load_changes = cycle.changes;
  settings.design = supervisor::Design::kAdaptive;
  const Outcome unnamed = run(cycle.robot, settings);
  const trials::UpdateLogicRun named = run_by(robot::UpdateMethod::kDistinctPoles);
  ASSERT_EQ(named.result.gains.size(), unnamed.result.gains.size());
  for (std::size_t i = 0; i < named.result.gains.size(); ++i) {
    EXPECT_EQ(named.result.gains[i].effective_tick, unnamed.result.gains[i].effective_tick);
    EXPECT_EQ(named.result.gains[i].k_force, unnamed.result.gains[i].k_force);
  }
}

}  // namespace update_logic_test
}  // namespace farrier::scenario
