#include "diagnosis.hpp"

#include <fstream>

#include "report/diagnosis/extended_model.hpp"

#include "core/replace_file.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::report {
namespace extended_model_test {

using testing::active;

class ExtendedModel : public testing::OwnFolder {
 protected:
  const robot::Robot robot_ = testing::rig();
};

TEST_F(ExtendedModel, LoadsWithTheEffectsBesideThoseThatWereThere) {
  const robot::Joint& joint = robot_.joints[0];
  const std::vector<plant::ActiveEffect> first{active(testing::two_effects()[1], joint)};
  const auto text = extended_model(robot_, joint, first);
  ASSERT_TRUE(text.ok()) << text.error().message;
  const auto loaded = robot::load_robot_text(text.value().text, "first");
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded.value().joints[0].effects, first);
  const auto more =
      extended_model(loaded.value(), loaded.value().joints[0], std::vector{active(testing::two_effects()[0], joint)});
  ASSERT_TRUE(more.ok()) << more.error().message;
  EXPECT_EQ(robot::load_robot_text(more.value().text, "more").value().joints[0].effects.size(), 2u);
}

TEST_F(ExtendedModel, OfARotaryJointLeavesTheOthersAlone) {
  const robot::Robot hyq = testing::hyq();
  const robot::Joint& hip = *hyq.find("rh_haa");
  const auto text = extended_model(hyq, hip, std::vector{active(testing::two_effects()[0], hip)});
  ASSERT_TRUE(text.ok()) << text.error().message;
  const robot::Robot loaded = robot::load_robot_text(text.value().text, "hyq").value();
  for (const robot::Joint& joint : loaded.joints) {
    EXPECT_EQ(joint.effects.size(), hyq.find(joint.name)->effects.size() + (joint.name == "rh_haa" ? 1u : 0u))
        << joint.name;
  }
}

TEST_F(ExtendedModel, RefusesWhatWouldNotLoad) {
  plant::ActiveEffect effect = active(testing::two_effects()[0], robot_.joints[0]);
  effect.values[0] = 1e9;
  const auto text = extended_model(robot_, robot_.joints[0], std::vector{effect});
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().message.find("coulomb_N"), std::string::npos) << text.error().message;
}

/// Effects of an electric joint by name and first value.
std::vector<plant::ActiveEffect> electric_effects(const robot::Joint& joint,
                                                  const std::vector<std::pair<const char*, double>>& named) {
  std::vector<plant::ActiveEffect> effects;
  for (const auto& [name, value] : named) {
    const plant::EffectId id = plant::find_nameable(name);
    std::vector<double> starts;
    for (const plant::Parameter& parameter : plant::effect_info(id).parameters) {
      starts.push_back(parameter.starts[0]);
    }
    effects.push_back(plant::active_effect(id, starts, robot::scales_of(joint)));
    effects.back().values[0] = value;
  }
  return effects;
}

robot::Robot loaded(const std::string& text) { return robot::load_robot_text(text, "extended").value(); }

TEST_F(ExtendedModel, OfAnElectricJointHasItsValuesInADriveAndALoadOfItsOwn) {
  const robot::Robot leg = testing::shipped("electric_leg");
  const robot::Joint& hip = *leg.find("haa");
  const auto model = extended_model(leg, hip,
                                    electric_effects(hip, {{"gear_stiffness", 8e3},
                                                           {"rotor_inertia", 5e-5},
                                                           {"torque_constant", 1.1},
                                                           {"gear_friction", 1.5},
                                                           {"load_damping", 3.0}}));
  ASSERT_TRUE(model.ok()) << model.error().message;
  EXPECT_TRUE(model.value().left_out.empty());
  const robot::Robot extended = loaded(model.value().text);
  const robot::Joint& changed = *extended.find("haa");
  EXPECT_EQ(changed.electric->spring_stiffness, 8e3);
  EXPECT_EQ(changed.electric->rotor_inertia_kg_m2, 5e-5);
  EXPECT_NEAR(changed.electric->torque_constant_Nm_A, 0.11, 1e-12);
  EXPECT_EQ(changed.electric->coulomb, 3.5);
  EXPECT_EQ(changed.swing_load.damping, 3.0);
  EXPECT_EQ(changed.stance_load.damping, 3.0);
  EXPECT_EQ(changed.swing_load.mass, hip.swing_load.mass);
  for (const char* other : {"hfe", "kfe"}) {
    EXPECT_EQ(extended.find(other)->electric->spring_stiffness, 1e4) << other;
    EXPECT_EQ(extended.find(other)->swing_load.damping, 2.0) << other;
  }
}

TEST_F(ExtendedModel, OfOneOfFourLikeJointsLeavesTheOthersAndItsSecondOneAddsNoSection) {
  const robot::Robot go1 = testing::shipped("go1");
  const robot::Joint& hip = *go1.find("rf_haa");
  const auto first = extended_model(
      go1, hip, electric_effects(hip, {{"load_mass", 0.06}, {"current_lag", 0.003}, {"current_limit", 15.0}}));
  ASSERT_TRUE(first.ok()) << first.error().message;
  const robot::Robot extended = loaded(first.value().text);
  for (const robot::Joint& joint : extended.joints) {
    const bool mine = joint.name == "rf_haa";
    const robot::Joint& was = *go1.find(joint.name);
    EXPECT_EQ(joint.swing_load.mass, mine ? 0.06 : was.swing_load.mass) << joint.name;
    EXPECT_NEAR(joint.electric->torque_time_constant_s, mine ? 0.004 : 0.001, 1e-12) << joint.name;
    EXPECT_EQ(joint.actuator.valve_current_max_A, mine ? 15.0 : was.actuator.valve_current_max_A) << joint.name;
  }
  const robot::Joint& again = *extended.find("rf_haa");
  const robot::Robot second =
      loaded(extended_model(extended, again, electric_effects(again, {{"load_mass", 0.07}})).value().text);
  EXPECT_EQ(second.find("rf_haa")->swing_load.mass, 0.07);
  EXPECT_EQ(second.file.loads.size(), extended.file.loads.size());
  EXPECT_EQ(second.file.joints.size(), extended.file.joints.size());
}

TEST_F(ExtendedModel, OfAnElectricJointSaysWhichEffectsARobotFileHasNoPlaceFor) {
  const robot::Robot leg = testing::shipped("electric_leg");
  const robot::Joint& hip = *leg.find("haa");
  const auto some = extended_model(leg, hip, electric_effects(hip, {{"cogging", 1.0}, {"load_mass", 0.2}}));
  ASSERT_TRUE(some.ok());
  EXPECT_EQ(some.value().left_out, std::vector<std::string>{"cogging: a robot file has no value for it"});
  EXPECT_EQ(loaded(some.value().text).find("haa")->swing_load.mass, 0.2);
  EXPECT_TRUE(extended_model(leg, hip, electric_effects(hip, {{"cogging", 1.0}})).value().text.empty());

  const robot::Robot go1 = testing::shipped("go1");
  const auto constant = extended_model(go1, go1.joints[0], electric_effects(go1.joints[0], {{"torque_constant", 1.1}}));
  EXPECT_TRUE(constant.value().text.empty());
  EXPECT_EQ(
      constant.value().left_out,
      std::vector<std::string>{"torque_constant: the drive computes its torque by its own constant, so set it there"});
}

TEST_F(ExtendedModel, SaysThatASpringIsTooStiffForTheElectricModel) {
  const robot::Robot leg = testing::shipped("electric_leg");
  const robot::Joint& hip = *leg.find("haa");
  const auto model = extended_model(leg, hip, electric_effects(hip, {{"gear_stiffness", 9e4}}));
  ASSERT_TRUE(model.ok());
  EXPECT_TRUE(model.value().text.empty());
  EXPECT_EQ(model.value().left_out,
            std::vector<std::string>{"gear_stiffness: a drive with so stiff a spring counts as rigid in a robot file"});
}

TEST_F(ExtendedModel, ItsFileIsReplacedWholeOrNotAtAll) {
  const std::string file = path_ + "/model.yaml";
  ASSERT_TRUE(replace_file(file, "old").ok());
  ASSERT_TRUE(replace_file(file, "new").ok());
  std::ifstream stream(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), "new");
  EXPECT_FALSE(std::filesystem::exists(file + ".part"));
  EXPECT_FALSE(replace_file(path_ + "/nowhere/model.yaml", "new").ok());
}

}  // namespace extended_model_test
}  // namespace farrier::report
