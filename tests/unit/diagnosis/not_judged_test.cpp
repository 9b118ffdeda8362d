// Which effects a recording cannot show.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/diagnosis.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace not_judged_test {

/// The rig under a slow sine of the current.
Recording slow_sine(double amplitude_A) {
  return recorded_rig(3000, rig().swing_load, [amplitude_A](int k) { return amplitude_A * std::sin(2.0 * k * 1e-3); });
}

std::vector<std::string> not_judged_in(const Recording& recording) {
  std::vector<std::string> names;
  for (const plant::EffectId id : diagnose(recording, rig()).judgement.not_judged) {
    names.emplace_back(plant::effect_info(id).name);
  }
  return names;
}

bool lists(const std::vector<std::string>& names, const char* name) {
  return std::ranges::find(names, name) != names.end();
}

TEST(NotJudged, EffectsOfTheValveAreInARecordingWithoutItsCurrent) {
  Recording recording = slow_sine(1e-3);
  recording.valve_current_A.clear();
  const auto names = not_judged_in(recording);
  EXPECT_TRUE(lists(names, "valve_deadband"));
  EXPECT_TRUE(lists(names, "supply_droop"));
  EXPECT_FALSE(lists(names, "load_friction"));
  EXPECT_FALSE(lists(names, "force_sensor_offset"));
}

TEST(NotJudged, AVelocityThatWasDerivedSaysNothingOfItsSensor) {
  Recording recording = slow_sine(1e-3);
  recording.velocity_derived = true;
  recording.derived_velocity_noise = rig().noise.velocity;
  EXPECT_TRUE(lists(not_judged_in(recording), "velocity_filter_lag"));
}

TEST(NotJudged, ASlowMotionDoesNotShowALagOfTheVelocitySensorButABiasOfTheValve) {
  const auto names = not_judged_in(slow_sine(0.3e-3));
  EXPECT_TRUE(lists(names, "velocity_filter_lag"));
  EXPECT_FALSE(lists(names, "valve_bias"));
}

}  // namespace not_judged_test
}  // namespace farrier::diagnosis
