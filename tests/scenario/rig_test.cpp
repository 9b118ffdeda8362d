// The thesis's one-joint rig.

#include <cmath>
#include <map>

#include "gait/schedule.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::scenario {
namespace rig_test {

using gait::Phase;

constexpr Tick kTicks = 3000;

run::InprocRun settings(supervisor::Design design) {
  run::InprocRun run;
  run.ticks = kTicks;
  run.design = design;
  return run;
}

TEST(Rig, RunsWithEitherDesign) {
  const robot::Robot rig = load("fc1d");
  for (const auto design : {supervisor::Design::kStance, supervisor::Design::kSwing}) {
    for (const trace::TraceRow& row : run(rig, settings(design)).rows) {
      ASSERT_TRUE(std::isfinite(row.position_m_or_rad) && std::isfinite(row.force_N_or_Nm));
      ASSERT_TRUE(std::abs(row.valve_current_A) <= rig.joints[0].actuator.valve_current_max_A);
      ASSERT_EQ(row.state == signals::JointState::kTracking, row.tick >= rig.update_logic.gain_lead_ticks);
    }
  }
}

TEST(Rig, TracksTheHeavyCartBetterWithTheDesignForIt) {
  const robot::Robot rig = load("fc1d");
  const gait::Schedule schedule(rig.plan, 1);
  std::map<supervisor::Design, double> nrmse;
  for (const auto design : {supervisor::Design::kStance, supervisor::Design::kSwing}) {
    const Outcome outcome = run(rig, settings(design));
    nrmse[design] = report::track(rig, schedule, outcome.rows, 0).joints.at(0).stance.nrmse;
  }
  EXPECT_LT(nrmse[supervisor::Design::kStance], nrmse[supervisor::Design::kSwing]);
  RecordProperty("stance_design", std::to_string(nrmse[supervisor::Design::kStance]));
  RecordProperty("swing_design", std::to_string(nrmse[supervisor::Design::kSwing]));
}

std::vector<Tick> changes(const Outcome& outcome, Phase trace::TraceRow::*phase) {
  std::vector<Tick> ticks;
  Phase last = Phase::kStance;
  for (const trace::TraceRow& row : outcome.rows) {
    if (row.*phase != last) {
      ticks.push_back(row.tick);
      last = row.*phase;
    }
  }
  return ticks;
}

TEST(Rig, ChangesGainsAtTheAnnouncedTickWhereverTheTouchdownReallyIs) {
  const robot::Robot exact = load_with_jitter("fc1d", 0.0);
  const robot::Robot jittery = load_with_jitter("fc1d", 0.015);
  const Outcome on_time = run(exact, settings(supervisor::Design::kPhases));
  const Outcome early_or_late = run(jittery, settings(supervisor::Design::kPhases));
  const auto planned = changes(on_time, &trace::TraceRow::phase);
  EXPECT_GE(planned.size(), 4u);
  EXPECT_EQ(changes(on_time, &trace::TraceRow::actual_phase), planned);
  EXPECT_EQ(changes(early_or_late, &trace::TraceRow::phase), planned) << "the announcement moved with the jitter";
  EXPECT_NE(changes(early_or_late, &trace::TraceRow::actual_phase), planned) << "the jitter did nothing";

  const gait::Schedule schedule(exact.plan, 1);
  for (const trace::TraceRow& row : early_or_late.rows) {
    ASSERT_EQ(row.phase, schedule.phase(0, row.tick)) << "tick " << row.tick;
    if (row.tick >= exact.update_logic.gain_lead_ticks) {
      ASSERT_EQ(row.generation, row.phase == Phase::kSwing ? 1u : 2u);
    }
  }
}

}  // namespace rig_test
}  // namespace farrier::scenario
