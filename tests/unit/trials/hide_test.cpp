#include "trials/hide.hpp"

#include <set>

#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::trials {
namespace hide_test {

using plant::EffectId;

robot::Robot hyq() { return robot::load_shipped("hyq", {.without_effects = true}); }

TEST(HiddenEffect, IsTheSameForTheSameSeedAndTellsWhatItIs) {
  const robot::Robot nominal = hyq();
  HiddenEffect one, other;
  const robot::Robot world = hide_effect(nominal, 5, one);
  hide_effect(nominal, 5, other);
  EXPECT_EQ(one.joint, other.joint);
  EXPECT_EQ(one.effect, other.effect);
  EXPECT_EQ(one.value, other.value);
  const robot::Joint& joint = *world.find(one.joint);
  ASSERT_EQ(joint.effects.size(), 1u);
  EXPECT_EQ(joint.effects[0].info().name, one.effect);
  EXPECT_EQ(plant::parameter_value(joint.effects[0], one.parameter), one.value);
}

TEST(HiddenEffect, LeavesWhatEverybodyElseBelievesIn) {
  const robot::Robot nominal = hyq();
  HiddenEffect what;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const robot::Robot world = hide_effect(nominal, seed, what);
    EXPECT_EQ(print_config(world), print_config(nominal));
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
      const robot::Joint& joint = world.joints[i];
      EXPECT_EQ(joint.effects.size(), joint.name == what.joint ? 1u : 0u);
      EXPECT_EQ(joint.swing_load.mass != nominal.joints[i].swing_load.mass,
                joint.name == what.joint && what.effect == "load_mass");
      const auto& plan = world.plan.legs[static_cast<std::size_t>(joint.leg)];
      EXPECT_EQ(plan.joints[static_cast<std::size_t>(joint.index_in_leg)].swing_load.mass,
                nominal.joints[i].swing_load.mass);
    }
  }
}

TEST(HiddenEffect, IsAnyOfAllOnAnyJoint) {
  const robot::Robot nominal = hyq();
  std::set<std::string> joints, effects;
  HiddenEffect what;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    hide_effect(nominal, seed, what);
    joints.insert(what.joint);
    effects.insert(what.effect);
  }
  EXPECT_EQ(joints.size(), nominal.joints.size());
  EXPECT_EQ(effects.size(), plant::kEffectCount);
}

// Nothing is hidden that a robot file could not say, or that cannot be simulated.
TEST(HiddenEffect, CouldStandInAFileAndCanBeSimulated) {
  for (const char* name : {"hyq", "fc1d"}) {
    const robot::Robot nominal = robot::load_shipped(name, {.without_effects = true});
    const std::size_t joints = std::min<std::size_t>(3, nominal.joints.size());
    for (std::size_t joint = 0; joint < joints; ++joint) {
      for (EffectId id = 0; id < plant::kEffectCount; ++id) {
        for (const std::uint64_t seed : {1, 2, 3}) {
          HiddenEffect what;
          const robot::Robot world = hide_effect(nominal, joint, id, seed, what);
          const auto simulated = sim_bridge::SimWorld::create(world, 1);
          EXPECT_TRUE(simulated.ok()) << what.effect << ": " << simulated.error().message;
          const auto said = robot::load_robot_text(robot::text_without_effects(name) + "\neffects:\n  " + what.joint +
                                                       ":\n    " + what.effect + ": {" + what.parameter + ": " +
                                                       config::number_text(what.value) + "}\n",
                                                   "f.yaml");
          ASSERT_TRUE(said.ok()) << to_string(said.error());
          EXPECT_EQ(said.value().joints[joint].effects, world.joints[joint].effects) << what.effect;
          EXPECT_EQ(said.value().joints[joint].stance_load.mass, world.joints[joint].stance_load.mass);
        }
      }
    }
  }
}

TEST(HiddenEffect, IsOneThatTheJointLacks) {
  robot::Robot robot = hyq();
  HiddenEffect what;
  robot = hide_effect(robot, 7, what);
  const HiddenEffect first = what;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    hide_effect(robot, seed, what);
    EXPECT_FALSE(what.joint == first.joint && what.effect == first.effect);
  }
}

}  // namespace hide_test
}  // namespace farrier::trials
