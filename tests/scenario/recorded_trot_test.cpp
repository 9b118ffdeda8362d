// Recordings of whole runs: complete, harmless, and enough to find what is hidden.

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/diagnosis.hpp"
#include "gait/schedule.hpp"
#include "trials/hide.hpp"
#include "tests/scenario/scenario_run.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tools/offline/joint_recording.hpp"
#include "tools/playback/rerun.hpp"
#include "report/figures/recording_facts.hpp"

namespace farrier::scenario {
namespace recorded_trot_test {

class RecordedTrot : public testing::Test {
 protected:
  run::InprocRun recorded(Tick ticks) const {
    run::InprocRun settings;
    settings.ticks = ticks;
    settings.design = supervisor::Design::kAdaptive;
    settings.record_path = path_;
    settings.record_facts = report::recording_facts(hyq_);
    return settings;
  }

  diagnosis::Recording read(const std::string& joint) const {
    auto recording = offline::read_joint_recording(path_, joint);
    EXPECT_TRUE(recording.ok()) << (recording ? "" : diagnosis::to_string(recording.error().findings, joint));
    return recording ? std::move(recording).value() : diagnosis::Recording{};
  }

  playback::Rerun rerun() const {
    auto run = playback::RecordedRun::open(path_);
    EXPECT_TRUE(run.ok()) << (run ? "" : run.error().message);
    auto rerun = playback::rerun_estimator(run.value());
    EXPECT_TRUE(rerun.ok()) << (rerun ? "" : rerun.error().message);
    return std::move(rerun).value();
  }

  const robot::Robot hyq_ = load("hyq");
  const test::ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
};

TEST_F(RecordedTrot, LeavesTheTraceAsItIsAndHoldsEveryTickAsMeasured) {
  constexpr Tick kTicks = 4000;
  constexpr double kDeviations = 6.0;  // of the noise, which one sample in 10^9 exceeds
  run::InprocRun settings;
  settings.ticks = kTicks;
  const Outcome plain = run(hyq_, settings);
  settings.record_path = path_;
  settings.record_facts = report::recording_facts(hyq_);
  const Outcome recorded = run(hyq_, settings);
  EXPECT_TRUE(recorded.trace == plain.trace);
  for (const robot::Joint& joint : hyq_.joints) {
    const diagnosis::Recording r = read(joint.name);
    ASSERT_EQ(r.time_s.size(), static_cast<std::size_t>(kTicks)) << joint.name;
    bool noisy = false;
    for (Tick tick = 0; tick < kTicks; ++tick) {
      const auto k = static_cast<std::size_t>(tick);
      const trace::TraceRow& row = recorded.at(tick, joint.number, hyq_.joints.size());
      ASSERT_EQ(r.valve_current_A[k], row.valve_current_A) << joint.name << ' ' << tick;
      ASSERT_LE(std::abs(r.force[k] - row.force_N_or_Nm), kDeviations * joint.noise.force) << joint.name << ' ' << tick;
      noisy = noisy || r.force[k] < row.force_N_or_Nm || r.force[k] > row.force_N_or_Nm;
      ASSERT_FALSE(r.swing[k] == 1 && row.actual_phase == gait::Phase::kStance) << joint.name << ' ' << tick;
    }
    EXPECT_TRUE(noisy) << joint.name;
    EXPECT_GT(std::ranges::count(r.swing, 1), kTicks / 10) << joint.name;
  }
}

TEST_F(RecordedTrot, ShowsAHiddenLossOfTheLoadCellsGainAndNothingBesideIt) {
  trials::HiddenEffect what;
  const robot::Joint& knee = *hyq_.find("lf_kfe");
  const robot::Robot world =
      trials::hide_effect(hyq_, knee.number, plant::effect_id<plant::ForceSensorGain>(), 1, what);
  run::InprocRun settings = recorded(6000);
  settings.simulated = &world;
  run(hyq_, settings);
  const diagnosis::Diagnosis found = diagnosis::diagnose(read("lf_kfe"), knee);
  ASSERT_FALSE(found.judgement.effects.empty()) << to_string(found.judgement.verdict);
  EXPECT_EQ(plant::effect_info(found.judgement.effects.front().id).name, what.effect);
  const diagnosis::Diagnosis other = diagnosis::diagnose(read("rf_kfe"), *hyq_.find("rf_kfe"));
  EXPECT_EQ(other.judgement.verdict, diagnosis::Verdict::kNone);
}

TEST_F(RecordedTrot, GivesTheSameEstimatesAgainToTheLastBit) {
  constexpr Tick kTicks = 3000;
  run(hyq_, recorded(kTicks));
  const playback::Rerun again = rerun();
  EXPECT_EQ(again.first_tick, 0);
  EXPECT_EQ(again.ending, "");
  ASSERT_EQ(again.joints.size(), hyq_.joints.size());
  for (const playback::RerunJoint& joint : again.joints) {
    EXPECT_EQ(joint.measurements, static_cast<std::uint64_t>(kTicks));
    EXPECT_EQ(joint.missing, 0u);
    EXPECT_EQ(joint.compared, static_cast<std::uint64_t>(1 + (kTicks - 1) / hyq_.estimate_period_ticks));
    EXPECT_EQ(joint.different, 0u) << (joint.first ? joint.first->field : "");
    EXPECT_EQ(joint.unanswered + joint.unrecorded, 0u);
  }
}

TEST_F(RecordedTrot, TellsAnEstimatorThatHasChanged) {
  constexpr Tick kTicks = 1000;
  run::InprocRun settings = recorded(kTicks);
  robot::Overrides other;
  other.estimator = "greybox";
  settings.record_facts = report::recording_facts(load("hyq", other));
  run(hyq_, settings);
  const playback::Rerun again = rerun();
  EXPECT_GT(again.joints.front().different, 0u);
  ASSERT_TRUE(again.joints.front().first);
  EXPECT_NE(again.joints.front().first->field, "");
}

}  // namespace recorded_trot_test
}  // namespace farrier::scenario
