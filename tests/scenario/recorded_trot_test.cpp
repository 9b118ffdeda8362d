// Recordings of whole runs: complete, harmless, and enough to find what is hidden.

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis.hpp"
#include "gait/schedule.hpp"
#include "lab/hide.hpp"
#include "lab/recorder.hpp"
#include "tests/scenario/scenario_run.hpp"

namespace farrier::scenario {
namespace {

namespace fs = std::filesystem;

class RecordedTrot : public testing::Test {
 protected:
  RecordedTrot() : directory_(fs::temp_directory_path() / ("farrier_recorded_" + std::to_string(::getpid()))) {}
  ~RecordedTrot() override { fs::remove_all(directory_); }

  diagnosis::Recording read(const std::string& joint) const {
    auto recording = diagnosis::read_recording(lab::Recorder::path_of(directory_.string(), joint));
    EXPECT_TRUE(recording.ok()) << (recording ? "" : diagnosis::to_string(recording.error().findings, joint));
    return recording ? std::move(recording).value() : diagnosis::Recording{};
  }

  const robot::Robot hyq_ = load("hyq");
  const fs::path directory_;
};

TEST_F(RecordedTrot, LeavesTheTraceAsItIsAndHoldsEveryTickAsMeasured) {
  constexpr Tick kTicks = 4000;
  constexpr double kDeviations = 6.0;  // of the noise, which one sample in 10^9 exceeds
  lab::InprocRun settings;
  settings.ticks = kTicks;
  const Outcome plain = run(hyq_, settings);
  settings.record_directory = directory_.string();
  const Outcome recorded = run(hyq_, settings);
  EXPECT_TRUE(recorded.trace == plain.trace);
  for (const robot::Joint& joint : hyq_.joints) {
    const diagnosis::Recording r = read(joint.name);
    ASSERT_EQ(r.time_s.size(), static_cast<std::size_t>(kTicks)) << joint.name;
    bool noisy = false;
    for (Tick tick = 0; tick < kTicks; ++tick) {
      const auto k = static_cast<std::size_t>(tick);
      const record::TraceRow& row = recorded.at(tick, joint.number, hyq_.joints.size());
      ASSERT_EQ(r.valve_current_A[k], row.valve_current_A) << joint.name << ' ' << tick;
      ASSERT_LE(std::abs(r.force[k] - row.force_N_or_Nm), kDeviations * joint.noise.force) << joint.name << ' ' << tick;
      noisy = noisy || r.force[k] < row.force_N_or_Nm || r.force[k] > row.force_N_or_Nm;
      ASSERT_FALSE(r.swing[k] == 1 && row.actual_phase == static_cast<std::uint8_t>(gait::Phase::kStance))
          << joint.name << ' ' << tick;
    }
    EXPECT_TRUE(noisy) << joint.name;
    EXPECT_GT(std::ranges::count(r.swing, 1), kTicks / 10) << joint.name;
  }
}

TEST_F(RecordedTrot, ShowsAHiddenLossOfTheLoadCellsGainAndNothingBesideIt) {
  lab::HiddenEffect what;
  const robot::Joint& knee = *hyq_.find("lf_kfe");
  const robot::Robot world =
      lab::hide_effect(hyq_, knee.number, plant::effect_id<plant::ForceSensorGain>(), 1, what);
  lab::InprocRun settings;
  settings.ticks = 6000;
  settings.design = supervisor::Design::kAdaptive;
  settings.world = &world;
  settings.record_directory = directory_.string();
  run(hyq_, settings);
  const diagnosis::Diagnosis found = diagnosis::diagnose(read("lf_kfe"), knee);
  ASSERT_FALSE(found.judgement.effects.empty()) << to_string(found.judgement.verdict);
  EXPECT_EQ(plant::effect_info(found.judgement.effects.front().id).name, what.effect);
  const diagnosis::Diagnosis other = diagnosis::diagnose(read("rf_kfe"), *hyq_.find("rf_kfe"));
  EXPECT_EQ(other.judgement.verdict, diagnosis::Verdict::kNone);
}

}  // namespace
}  // namespace farrier::scenario
