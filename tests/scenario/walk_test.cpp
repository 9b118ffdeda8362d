// The whole robot on a ground through all processes, in one thread.

#include <cmath>
#include <fstream>

#include "gait/late_touchdowns.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::scenario {
namespace walk_test {

run::InprocRun settings(double seconds, std::vector<double> velocity) {
  run::InprocRun run;
  run.ticks = static_cast<Tick>(seconds * 1000.0);
  run.design = supervisor::Design::kPhases;
  run.world = participant::World::kIdeal;
  run.velocity = std::move(velocity);
  return run;
}

TEST(Walk, LiesUntilItIsAskedToStand) {
  const robot::Robot hyq = load("hyq");
  const Outcome lying = run(hyq, settings(4.0, {}));
  const Outcome standing = run(hyq, settings(6.0, {0.0, 0.0, 0.0}));
  const auto knee = static_cast<std::size_t>(hyq.find("lf_kfe")->number);
  const double folded = lying.at(3999, knee, hyq.joints.size()).position_m_or_rad;
  const double stretched = standing.at(5999, knee, hyq.joints.size()).position_m_or_rad;
  EXPECT_GT(std::abs(stretched - folded), 0.005) << "the knee's piston stands elsewhere in a robot that stands";
}

/// A walk that two tests judge.
const std::vector<trace::TraceRow>& rows_of_a_walk() {
  static const std::vector<trace::TraceRow> rows = run(load("hyq"), settings(10.0, {0.4, 0.0, 0.0})).rows;
  return rows;
}

TEST(Walk, HasNoJointThatTripsOrLosesItsReadings) {
  for (const trace::TraceRow& row : rows_of_a_walk()) {
    const FaultSet faults(row.faults);
    ASSERT_FALSE(faults.has(Fault::kTripped)) << row.tick;
    ASSERT_FALSE(row.tick > 10 && faults.has(Fault::kSensorsStale)) << row.tick;
    ASSERT_FALSE(row.tick > 10 && row.state != signals::JointState::kTracking) << row.tick;
  }
}

TEST(Walk, AnnouncesThePhasesOfItsLegs) {
  int swings = 0;
  for (const trace::TraceRow& row : rows_of_a_walk()) {
    swings += row.joint == 0 && row.phase == Phase::kSwing && row.actual_phase == Phase::kSwing ? 1 : 0;
  }
  EXPECT_GT(swings, 200) << "a leg whose foot is in the air has the gains of swing";
}

// Blocks end swings early. In the study of trials/body as over the bus, the joints hear of it.
TEST(Walk, ChangesGainsByFeltTouchdownsAsTheStudyDoes) {
  const robot::Robot hyq = load("hyq", {.on_ground = true});
  constexpr double kSeconds = 10.5;
  const std::string text =
      "friction: 0.8\nblocks: {field: {x_m: 0.45, y_m: -1.5, length_m: 4, width_m: 3, size_m: 0.3, "
      "height_m: 0.08, seed: 1}}\n";
  const std::string scene = testing::TempDir() + "felt_blocks.yaml";
  std::ofstream(scene) << text;
  run::InprocRun walk = settings(kSeconds, {0.4, 0.0, 0.0});
  walk.world = participant::World::kBody;
  walk.scene_path = scene;
  const Outcome processes = run(hyq, walk);
  std::vector<gait::LateTouchdowns> legs(hyq.plan.legs.size());
  for (const trace::TraceRow& row : processes.rows) {
    if (hyq.joints[row.joint].index_in_leg == 0) {
      legs[static_cast<std::size_t>(hyq.joints[row.joint].leg)].step(row.actual_phase, row.phase);
    }
  }
  const double late_s = gait::total_of(legs, hyq.period_s).sum;
  const auto felt = std::ranges::count_if(processes.result.phases, [](const auto& phase) { return phase.felt != 0; });
  EXPECT_GT(felt, 2);

  const trials::TrotCase one{
      .trial = "blocks",
      .name = "felt",
      .seed = walk.seed,
      .scene = text,
      .script = locomotion::walk_script({.request = locomotion::Request::kTrot, .forward_m_s = 0.4}),
      .trot_s = locomotion::kWalk_s,
      .judged_from_s = locomotion::kWalk_s,
      .judged_until_s = kSeconds,
      .end_s = kSeconds};
  const trials::GainSwitches study = trials::run_trot_case(hyq, one, trials::Joints::kActuators).value()->switches;
  // The first ticks differ: a supervisor arms the joints there. So feet meet the blocks a few ticks apart.
  constexpr double kApart = 2.0, kLate_ms = 10.0;
  EXPECT_EQ(study.planned, std::ssize(processes.result.phases) - felt);
  EXPECT_NEAR(study.felt, static_cast<double>(felt), kApart);
  EXPECT_LT(study.late_s, 1e-3 * kLate_ms * study.felt);
  EXPECT_LT(late_s, 1e-3 * kLate_ms * static_cast<double>(felt));
}

// By the pressure that sim_bridge tells, through all processes.
TEST(Walk, EndsLyingWhenThePumpStops) {
  const std::string scene = testing::TempDir() + "pump_stops.yaml";
  std::ofstream(scene) << "supply: {cut: {start_s: 4, pump_flow_m3_s: 0}}\n";
  run::InprocRun stand = settings(6.0, {0.0, 0.0, 0.0});
  stand.world = participant::World::kBody;
  stand.scene_path = scene;
  const robot::Robot hyq =
      robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.pattern = {}, .frequency_Hz = {}, .on_ground = true}).value();
  const auto ran = run::run_inproc(hyq, stand);
  ASSERT_TRUE(ran) << ran.error().message;
  std::vector<std::string> told;
  for (const signals::SystemEvent& event : ran.value().events) {
    if (const std::string text(signals::text_of(event.text)); text.find("supply") != std::string::npos) {
      told.push_back(std::to_string(event.tick) + " " + text);
    }
  }
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0], "4109 lies down: the supply cannot carry the robot");
  EXPECT_NE(told[1].find("supply low"), std::string::npos) << told[1];
}

TEST(Walk, RefusesARobotWithoutATrunk) {
  const robot::Robot rig = load("fc1d");
  const auto refused = run::run_inproc(rig, settings(1.0, {}));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("body.trunk"), std::string::npos) << refused.error().message;
}

}  // namespace walk_test
}  // namespace farrier::scenario
