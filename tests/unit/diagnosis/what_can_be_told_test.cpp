// Effects that a recording shows and tells apart, before any verdict.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "diagnosis/separability/what_can_be_told.hpp"
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
  ASSERT_TRUE(pair->remedy.column);
  EXPECT_EQ(*pair->remedy.column, Channel::kForce);
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

std::vector<plant::EffectId> set_of(std::initializer_list<const char*> names) {
  std::vector<plant::EffectId> set;
  std::ranges::transform(names, std::back_inserter(set), [](const char* name) { return plant::find_nameable(name); });
  return set;
}

std::vector<std::string> names_in(const Judgement& judgement) {
  std::vector<std::string> names;
  std::ranges::transform(judgement.effects, std::back_inserter(names),
                         [](const NamedEffect& effect) { return plant::effect_info(effect.id).name; });
  std::ranges::sort(names);
  return names;
}

// Mass and damping at two frequencies are also those of a load with a part on a spring; a third tells them apart.
TEST(WhatCanBeTold, ASetThatARecordingSeparatesIsNamed) {
  plant::LoadParams load = rig().swing_load;
  load.mass *= 1.2;
  load.damping *= 1.2;
  Recording recording = recorded_rig(3000, load, [](int k) {
    const double time_s = k * 1e-3;
    return 1e-3 * std::sin(12.0 * time_s) + 0.5e-3 * std::sin(90.0 * time_s) + 0.5e-3 * std::sin(160.0 * time_s);
  });
  for (double& current_A : recording.valve_current_A) {
    current_A -= 3e-4;
  }
  const auto set = what_can_be_told(recording, rig(), set_of({"load_mass", "load_damping", "valve_bias"}), {});
  ASSERT_EQ(set.size(), 3u);
  for (const ToldMember& member : set) {
    EXPECT_TRUE(member.seen.separable()) << plant::effect_info(member.seen.beside.id).name;
    EXPECT_FALSE(member.remedy.column || member.remedy.experiment);
  }
  const Judgement judgement = diagnose(recording, rig()).judgement;
  for (const auto& [one, other] : judgement.alternatives) {
    ADD_FAILURE() << plant::effect_info(one).name << " or " << plant::effect_info(other).name;
  }
  EXPECT_EQ(judgement.verdict, Verdict::kEffects);
  EXPECT_EQ(names_in(judgement), (std::vector<std::string>{"load_damping", "load_mass", "valve_bias"}));
}

TEST(WhatCanBeTold, ASetOfAnOffsetAndAnExternalForceNeedsTheCurrentAndIsNotNamed) {
  Recording recording = sines();
  recording.valve_current_A.clear();
  const auto set = what_can_be_told(recording, rig(), set_of({"force_sensor_offset", "external_force"}), {});
  ASSERT_EQ(set.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_FALSE(set[i].seen.separable());
    EXPECT_EQ(set[i].seen.hidden_by, std::vector<plant::EffectId>{set[1 - i].seen.beside.id});
    EXPECT_EQ(set[i].remedy.column, Channel::kForce);
  }
  for (double& force_N : recording.force) {
    force_N += 40.0;
  }
  EXPECT_LT(names_in(diagnose(recording, rig()).judgement).size(), 2u);
}

TEST(WhatCanBeTold, AnEffectOfASetChangesLessBesideOneThatFollowsIt) {
  const Recording steady = recorded_rig(3000, rig().swing_load, [](int k) { return k / 1500 % 2 == 0 ? 1e-3 : -1e-3; });
  const auto alone = what_can_be_told(steady, rig(), set_of({"load_damping"}), {});
  ASSERT_TRUE(alone.front().seen.beside.shows);
  const auto set = what_can_be_told(steady, rig(), set_of({"load_damping", "load_friction"}), {});
  EXPECT_LT(set.front().seen.beside.change, 0.5 * alone.front().seen.beside.change);
}

TEST(WhatCanBeTold, AnEffectWithoutAColumnIsAskedForItsColumn) {
  Recording recording = sines();
  recording.valve_current_A.clear();
  const auto set = what_can_be_told(recording, rig(), set_of({"valve_bias", "load_friction"}), {});
  EXPECT_FALSE(set.front().seen.recorded);
  EXPECT_FALSE(set.front().seen.separable());
  EXPECT_EQ(set.front().remedy.column, Channel::kForce);
  EXPECT_TRUE(set.back().seen.separable());
}

}  // namespace what_can_be_told_test
}  // namespace farrier::diagnosis
