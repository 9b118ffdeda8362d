// Robot files with electric joints.

#include <gtest/gtest.h>

#include <algorithm>

#include "plant/electric_actuator.hpp"
#include "robot/derive.hpp"
#include "robot/joint_model.hpp"
#include "robot/joint_plant.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace electric_test {

TEST(ElectricLeg, HasWhatItsFileSaysInEveryJoint) {
  const Robot leg = load_shipped("electric_leg");
  ASSERT_EQ(leg.joints.size(), 3u);
  for (const Joint& joint : leg.joints) {
    ASSERT_TRUE(joint.electric.has_value());
    EXPECT_TRUE(joint.rotary);
    EXPECT_EQ(joint.electric->gear_ratio, 50.0);
    EXPECT_EQ(joint.electric->spring_stiffness, 1e4);
    EXPECT_EQ(joint.actuator.valve_current_max_A, plant::current_max_A(*joint.electric));
    EXPECT_EQ(joint.actuator.stroke, 2.6);
    EXPECT_EQ(joint.normalisation.current_A, 300.0);
    EXPECT_EQ(joint.push_limit, 100.0) << "the rating, below the stall torque";
    EXPECT_EQ(joint.pull_limit, 100.0);
    EXPECT_TRUE(make_plant(joint, joint.stance_load).ok());
  }
  EXPECT_EQ(leg.first_electric(), &leg.joints[0]);
  EXPECT_EQ(load_shipped("hyq").first_electric(), nullptr);
}

TEST(ElectricLeg, IsDesignedForByTheModelOfItsMotor) {
  const Robot leg = load_shipped("electric_leg");
  const Joint& knee = leg.joints[2];
  const plant::LinearModel model = plant::linearise_load_cell_force(*knee.electric, knee.swing_load);
  const control::DiscreteModel expected = control::discretise(model.a, model.b, leg.period_s);
  const control::DiscreteModel found = model_of(knee, knee.swing_load, leg.period_s);
  EXPECT_EQ(found.a, expected.a);
  EXPECT_EQ(found.b, expected.b);
}

TEST(ElectricLeg, PrintsAConfigurationThatLoadsToTheSameRobot) {
  const Robot leg = load_shipped("electric_leg");
  const auto again = load_robot_text(print_config(leg), "printed.yaml");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(configuration_hash(again.value()), configuration_hash(leg));
  EXPECT_EQ(again.value().joints[1].electric->rotor_inertia_kg_m2, leg.joints[1].electric->rotor_inertia_kg_m2);
}

// One change to electric_leg.yaml and the one problem it must cause, at the line of the change.
struct Mistake {
  const char* from;
  const char* to;
  const char* problem;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.to; }

class ElectricFileMistake : public testing::TestWithParam<Mistake> {};

TEST_P(ElectricFileMistake, IsReportedWithItsLineAndRemedy) {
  const std::string text = replaced(text_of("electric_leg"), GetParam().from, GetParam().to);
  const auto robot = load_robot_text(text, "leg.yaml");
  ASSERT_FALSE(robot.ok());
  const int line = line_of(text, GetParam().to);
  EXPECT_EQ(to_string(robot.error()), "leg.yaml:" + std::to_string(line) + ": " + GetParam().problem + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, ElectricFileMistake,
    testing::Values(Mistake{"gear_ratio: 50", "gear_ratio: 0.5",
                            "electric_actuators.drive.gear_ratio: 0.5 is out of range: give 1 to 1000"},
                    Mistake{"    angle_max_rad: 0.8", "    angle_max_rad: 1.2",
                            "joints.hfe.angle_max_rad: 1.2 puts actuator drive at 2.9, outside its stroke: 0 to 2.6"},
                    Mistake{"stance: {inertia_kg_m2: 0.6,", "stance: {inertia_kg_m2: -1,",
                            "loads.kfe.rotary.stance.inertia_kg_m2: -1 is out of range: give 1e-05 to 1000"}));

std::string problem_of(const std::string& text) {
  const auto robot = load_robot_text(text, "leg.yaml");
  return robot ? "" : to_string(robot.error());
}

TEST(ElectricLeg, CountsAsRigidWithASpringOnWhichTheRotorSwingsFast) {
  const auto robot = load_robot_text(
      replaced(text_of("electric_leg"), "spring_stiffness_Nm_rad: 1e4", "spring_stiffness_Nm_rad: 1e5"), "leg.yaml");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_TRUE(robot.value().joints[0].electric->rigid);
  EXPECT_NE(rigid_spring_note(robot.value().file).find("springs of drive"), std::string::npos);
  EXPECT_EQ(rigid_spring_note(load_shipped("electric_leg").file), "");
}

TEST(Go1, IsKnownByItsLimits) {
  const Robot go1 = load_shipped("go1", {.on_ground = true});
  ASSERT_EQ(go1.joints.size(), 12u);
  for (const Joint& joint : go1.joints) {
    ASSERT_TRUE(joint.electric.has_value());
    EXPECT_TRUE(joint.electric->rigid);
    EXPECT_EQ(joint.push_limit, 23.7);
    EXPECT_EQ(joint.normalisation.force, 23.7);
    EXPECT_NEAR(joint.normalisation.velocity, 1.05 * 30.1, 1e-9);
    EXPECT_NEAR(joint.noise.force, 0.0237, 1e-12);
    EXPECT_GT(joint.noise.position, 0.0) << "readings without noise count as frozen";
    const auto& links = go1.body->legs[static_cast<std::size_t>(joint.leg)].links;
    EXPECT_EQ(links[static_cast<std::size_t>(joint.index_in_leg)].armature_kg_m2, 0.01);
    EXPECT_TRUE(make_plant(joint, joint.stance_load).ok());
  }
  const auto again = load_robot_text(print_config(go1), "printed.yaml");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(configuration_hash(again.value()), configuration_hash(go1));
}

TEST(ElectricFileMistakes, IncludeAGreyBoxEstimator) {
  std::string text = text_of("electric_leg");
  text = replaced(text, "estimators:\n", "estimators:\n  greybox: {method: greybox, blank_ticks: 22}\n");
  text = replaced(text, "    load: haa\n    controller: torque\n    estimator: rls",
                  "    load: haa\n    controller: torque\n    estimator: greybox");
  EXPECT_EQ(problem_of(text), "leg.yaml:" + std::to_string(line_of(text, "    estimator: greybox")) +
                                  ": joints.haa.estimator: greybox estimates the physics of a hydraulic joint: an "
                                  "electric one takes another method\n");
}

TEST(ElectricFileMistakes, IncludeEffectsOfHydraulicJoints) {
  const std::string text = text_of("electric_leg") + "\neffects:\n  kfe: {valve_deadband: {half_width_A: 1e-4}}\n";
  EXPECT_NE(problem_of(text).find("effects.kfe: is an electric joint: effects are those of hydraulic ones"),
            std::string::npos)
      << problem_of(text);
}

TEST(ElectricFileMistakes, IncludeControllersThatInvertTheFlow) {
  const std::string text =
      replaced(text_of("electric_leg"), "    form: compliant", "    kind: feedback_linearisation\n    form: compliant");
  const std::string told = problem_of(text);
  for (const char* joint : {"haa", "hfe", "kfe"}) {
    EXPECT_NE(told.find("joints." + std::string(joint) +
                        ".controller: torque is of kind feedback_linearisation, which "
                        "inverts the flow of oil: an electric joint takes lqr or pid"),
              std::string::npos)
        << told;
  }
}

TEST(ElectricFileMistakes, IncludeHydraulicActuatorsWithoutASupply) {
  std::string text = text_of("hyq");
  const auto from = text.find("supply:\n");
  text.erase(from, text.find("\n\n", from) - from);
  EXPECT_NE(problem_of(text).find("supply: is missing: hydraulic actuators need it"), std::string::npos)
      << problem_of(text);
}

TEST(ElectricFileMistakes, IncludeARobotWithoutActuators) {
  std::string text = text_of("electric_leg");
  const auto from = text.find("electric_actuators:\n");
  text.erase(from, text.find("\n\n", from) - from);
  EXPECT_NE(problem_of(text).find("give actuators, electric_actuators or both"), std::string::npos) << problem_of(text);
}

TEST(HydraulicFileMistakes, IncludeTheLoadOfAnElectricJoint) {
  const std::string load = "{inertia_kg_m2: 1, damping_Nms_rad: 1}";
  const std::string text =
      replaced(text_of("hyq"), "loads:\n", "loads:\n  turned: {rotary: {swing: " + load + ", stance: " + load + "}}\n");
  const std::string told = problem_of(replaced(text, "    load: leg", "    load: turned"));
  EXPECT_NE(told.find("joints.haa.load: turned is for an electric joint: a hydraulic one takes one with leg_about_haa"),
            std::string::npos)
      << told;
}

}  // namespace electric_test
}  // namespace farrier::robot
