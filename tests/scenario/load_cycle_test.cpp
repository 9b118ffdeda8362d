#include "trials/load_cycle.hpp"
#include "scenario_run.hpp"

namespace farrier::scenario {
namespace load_cycle_test {

constexpr double kShortQuarter_s = 0.4;  // the transient and as much again

trials::LoadCycle cycle(double quarter_s = kShortQuarter_s) {
  return trials::make_load_cycle(load("fc1d"), quarter_s).value();
}

run::InprocRun settings(const trials::LoadCycle& cycle) {
  run::InprocRun run;
  run.ticks = cycle.begin.back();
  run.design = supervisor::Design::kSwing;
  run.load_changes = cycle.changes;
  return run;
}

constexpr double kFixedAtLeast = 1.0;       // heavy quarters: gains for the light load do not hold the heavy one
constexpr double kAdaptiveAtMost = 0.08;    // heavy quarters
constexpr double kGreyBoxAtMost = 0.08;     // every quarter, with the sensors' noise
constexpr double kNoiselessAtMost = 0.05;   // every quarter, without
constexpr double kLightRatioAtMost = 1.05;  // light quarters: adaptation must not cost what it need not

double quarter_error(const Outcome& outcome, const trials::LoadCycle& cycle, std::size_t quarter) {
  return trials::quarter_error(cycle, outcome.rows, quarter);
}

TEST(LoadCycle, IsThatOfFigure7_6) {
  const trials::LoadCycle of_rig = cycle(trials::kQuarter_s);
  const double friction = of_rig.robot.joints[0].swing_load.damping;
  const double mass_kg[] = {0.5, 50.0, 0.5, 50.0};
  const double frictions[] = {friction, friction, friction, 5.0 * friction};
  for (std::size_t i = 0; i < trials::kQuarters; ++i) {
    EXPECT_EQ(of_rig.loads[i].mass, mass_kg[i]);
    EXPECT_EQ(of_rig.loads[i].damping, frictions[i]);
    EXPECT_EQ(of_rig.begin[i + 1] - of_rig.begin[i], 1000);
  }
  EXPECT_EQ(of_rig.robot.plan.gait.pattern, gait::Pattern::kStand) << "nothing announces the change";
  EXPECT_EQ(of_rig.robot.joints[0].swing_load.mass, 0.5) << "what the first design is for";
}

TEST(LoadCycle, RefusesARobotWithLegs) { EXPECT_FALSE(trials::make_load_cycle(load("hyq"))); }

TEST(LoadCycle, ChangesTheLoadAndWithPerfectKnowledgeTheGainsAtTheTickOfEveryQuarter) {
  const trials::LoadCycle of_rig = cycle();
  run::InprocRun knowing = settings(of_rig);
  knowing.known_loads = of_rig.changes;
  const Outcome outcome = run(of_rig.robot, knowing);
  std::vector<Tick> heavier_or_lighter, other_gains;
  for (std::size_t i = 1; i < outcome.rows.size(); ++i) {
    const trace::TraceRow& before = outcome.rows[i - 1];
    const trace::TraceRow& now = outcome.rows[i];
    if (now.load_mass_kg_or_kgm2 != before.load_mass_kg_or_kgm2) {
      heavier_or_lighter.push_back(now.tick);
    }
    if (now.generation != before.generation && now.tick >= of_rig.begin[0]) {
      other_gains.push_back(now.tick);
    }
    ASSERT_EQ(now.phase, signals::Phase::kStance);
  }
  const std::vector<Tick> begins(of_rig.begin.begin() + 1, of_rig.begin.end() - 1);
  EXPECT_EQ(heavier_or_lighter, begins);
  EXPECT_EQ(other_gains, begins);
  EXPECT_EQ(outcome.result.gains.size(), 2u + 2u * trials::kQuarters) << "both slots, at the start and every quarter";
}

TEST(LoadCycle, IsLostWithGainsForTheLightLoadAndHeldWithGainsForTheTrueOne) {
  const trials::LoadCycle of_rig = cycle(trials::kQuarter_s);
  const Outcome fixed = run(of_rig.robot, settings(of_rig));
  run::InprocRun knowing = settings(of_rig);
  knowing.known_loads = of_rig.changes;
  const Outcome exact = run(of_rig.robot, knowing);
  for (const std::size_t heavy : {1u, 3u}) {
    EXPECT_GE(quarter_error(fixed, of_rig, heavy), kFixedAtLeast);
  }
  for (std::size_t quarter = 0; quarter < trials::kQuarters; ++quarter) {
    EXPECT_LE(quarter_error(exact, of_rig, quarter), of_rig.robot.bounds.stance_nrmse) << quarter;
  }
}

TEST(LoadCycle, IsHeldByAdaptiveGainsAndCostsNothingInTheLightQuarters) {
  const trials::LoadCycle of_rig = cycle(trials::kQuarter_s);
  constexpr std::uint64_t kSeed = 1;
  const auto outcome_of = [&](const trials::LoadCycleCase& one) {
    return run(trials::robot_of(of_rig, one), trials::run_of(of_rig, one, kSeed));
  };
  const Outcome adaptive = outcome_of(trials::kAdaptiveCase);
  const Outcome true_load = outcome_of(trials::kTrueLoadCase);
  for (const std::size_t heavy : {1u, 3u}) {
    EXPECT_LE(quarter_error(adaptive, of_rig, heavy), kAdaptiveAtMost) << heavy;
  }
  for (const std::size_t light : {0u, 2u}) {
    EXPECT_LE(quarter_error(adaptive, of_rig, light) / quarter_error(true_load, of_rig, light), kLightRatioAtMost)
        << light;
  }
}

// Every quarter, light ones included, from 0.2 s after each change of a load that nothing announces.
TEST(LoadCycle, IsHeldByTheGreyBoxInEveryQuarterWithSensorNoiseAndWithout) {
  const trials::LoadCycle of_rig = cycle(trials::kQuarter_s);
  constexpr std::uint64_t kSeed = 1;
  for (const trials::LoadCycleCase& one : {trials::kGreyBoxCase, trials::kGreyBoxNoiselessCase}) {
    const Outcome outcome = run(trials::robot_of(of_rig, one), trials::run_of(of_rig, one, kSeed));
    for (std::size_t quarter = 0; quarter < trials::kQuarters; ++quarter) {
      EXPECT_LE(quarter_error(outcome, of_rig, quarter), one.noiseless ? kNoiselessAtMost : kGreyBoxAtMost)
          << one.name << ", quarter " << quarter + 1;
    }
    EXPECT_GT(outcome.result.gains.size(), 2u) << "physics went out";
    for (const trace::TraceRow& row : outcome.rows) {
      ASSERT_TRUE(row.tick < 10 || row.state == signals::JointState::kTracking) << row.tick;
    }
  }
}

}  // namespace load_cycle_test
}  // namespace farrier::scenario
