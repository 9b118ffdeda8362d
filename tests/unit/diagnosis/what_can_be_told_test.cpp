// Effects that a recording shows and tells apart, before any verdict.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/what_can_be_told.hpp"
#include "tests/unit/diagnosis/rig.hpp"

namespace farrier::diagnosis {
namespace what_can_be_told_test {

/// The rig under two sines of the current.
Recording sines() {
  return recorded_rig(3000, rig().swing_load, [](int k) {
    const double time_s = k * 1e-3;
    return 1e-3 * std::sin(12.0 * time_s) + 0.5e-3 * std::sin(90.0 * time_s);
  });
}

const EffectVisibility* find(const WhatCanBeTold& told, std::string_view name) {
  const auto found = std::ranges::find_if(
      told.effects, [&](const EffectVisibility& one) { return plant::effect_info(one.id).name == name; });
  return found == told.effects.end() ? nullptr : &*found;
}

const Inseparable* find_pair(const WhatCanBeTold& told, std::string_view one, std::string_view other) {
  const auto found = std::ranges::find_if(told.pairs, [&](const Inseparable& pair) {
    const std::string_view a = plant::effect_info(pair.one).name;
    const std::string_view b = plant::effect_info(pair.other).name;
    return (a == one && b == other) || (a == other && b == one);
  });
  return found == told.pairs.end() ? nullptr : &*found;
}

TEST(WhatCanBeTold, ARecordingOfFastAndSlowMotionTellsFrictionFromDamping) {
  const WhatCanBeTold told = what_can_be_told(sines(), rig(), {});
  ASSERT_NE(find(told, "load_friction"), nullptr);
  EXPECT_TRUE(find(told, "load_friction")->shows);
  EXPECT_EQ(find_pair(told, "load_friction", "load_damping"), nullptr);
}

TEST(WhatCanBeTold, WithoutTheValvesCurrentAForceOffsetLooksLikeAnExternalForceAndTheCurrentWouldTell) {
  Recording recording = sines();
  recording.valve_current_A.clear();
  const WhatCanBeTold told = what_can_be_told(recording, rig(), {});
  const Inseparable* const pair = find_pair(told, "external_force", "force_sensor_offset");
  ASSERT_NE(pair, nullptr);
  EXPECT_LT(pair->left, 0.01);
  ASSERT_TRUE(pair->column);
  EXPECT_EQ(*pair->column, Channel::kForce);
  const auto valve = std::ranges::find_if(
      told.other_columns, [](plant::EffectId id) { return plant::effect_info(id).name == std::string("valve_bias"); });
  EXPECT_NE(valve, told.other_columns.end());
}

TEST(WhatCanBeTold, AnEffectShowsFromASizeThatGrowsWithTheNoise) {
  robot::Joint noisy = rig();
  noisy.noise.force *= 10.0;
  noisy.noise.position *= 10.0;
  noisy.noise.velocity *= 10.0;
  const Recording recording = sines();
  const WhatCanBeTold quiet = what_can_be_told(recording, rig(), {});
  const WhatCanBeTold told = what_can_be_told(recording, noisy, {});
  ASSERT_NE(find(told, "force_sensor_lag"), nullptr);
  EXPECT_GT(find(told, "force_sensor_lag")->shows_from, 5.0 * find(quiet, "force_sensor_lag")->shows_from);
}

// A verdict that names one effect alone would contradict the pair that the recording does not tell apart.
TEST(WhatCanBeTold, AVerdictLeavesOpenWhatTheRecordingDoesNotTellApart) {
  Recording recording = sines();
  recording.valve_current_A.clear();
  for (double& force_N : recording.force) {
    force_N += 40.0;
  }
  const Judgement judgement = diagnose(recording, rig()).judgement;
  EXPECT_EQ(judgement.verdict, Verdict::kCannotSeparate);
}

}  // namespace what_can_be_told_test
}  // namespace farrier::diagnosis
