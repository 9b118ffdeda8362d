// Robots as their public descriptions have them: rigid drives, joints known by their limits alone, and descriptions of
// another format.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace robot_cases {

std::string shipped(const std::string& name) { return std::string(FARRIER_ROBOTS) + "/" + name + ".yaml"; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// `text` with the lines from the one that begins with `from` up to the one before `end` replaced.
std::string section_replaced(std::string text, const std::string& from, const std::string& end, const std::string& to) {
  const auto begin = text.find(from);
  const auto until = text.find(end, begin);
  EXPECT_NE(until, std::string::npos) << from;
  return text.replace(begin, until - begin, to);
}

struct Answer {
  int status;
  std::string output;
};

/// The answer to a file of that content.
Answer trot(const std::string& content, const std::string& name, std::vector<std::string> options) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.file(name)) << content;
  options.insert(options.begin(), {"trot", "--robot", scratch.file(name), "--out", scratch.file("out")});
  Answer answer{};
  answer.status = run_farrier(options, &answer.output);
  return answer;
}

const std::vector<std::string> kOnBench{"--world", "bench", "--dds", "inproc", "--duration", "9"};

/// electric_leg's file with the public numbers of a small direct drive (Katz 2018): rotor on `spring`.
std::string direct_drive_leg(const std::string& spring) {
  std::string text =
      section_replaced(read_file(shipped("electric_leg")), "    torque_constant_Nm_A:", "    travel_rad:",
                       "    torque_constant_Nm_A: 0.05\n    winding_resistance_Ohm: 0.173\n"
                       "    winding_inductance_H: 3e-5\n    supply_voltage_V: 24\n"
                       "    rotor_inertia_kg_m2: 6.3e-5\n    gear_ratio: 6\n    coulomb_Nm: 0.2\n" +
                           spring);
  text = section_replaced(text, "    rated_torque_Nm:", "\nlinkages:", "    rated_torque_Nm: 18\n");
  text = section_replaced(text, "loads:\n", "controllers:",
                          "loads:\n"
                          "  haa: {rotary: {swing: &leg {inertia_kg_m2: 0.02, damping_Nms_rad: 0.1}, stance: *leg}}\n"
                          "  hfe: {rotary: {swing: {inertia_kg_m2: 0.012, damping_Nms_rad: 0.1}, "
                          "stance: {inertia_kg_m2: 0.12, damping_Nms_rad: 0.1}}}\n"
                          "  kfe: {rotary: {swing: {inertia_kg_m2: 0.0006, damping_Nms_rad: 0.05}, "
                          "stance: {inertia_kg_m2: 0.08, damping_Nms_rad: 0.05}}}\n\n");
  for (int joint = 0; joint < 3; ++joint) {
    text = replaced(text, "stiffness_Nm_rad: 150\n", "stiffness_Nm_rad: 40\n");
    text = replaced(text, "damping_Nms_rad: 5\n    dither", "damping_Nms_rad: 1\n    dither");
  }
  return replaced(text, "trunk_mass_kg: ", "trunk_mass_kg: 3.3 # ");
}

TEST(RobotCase, ARigidDriveWithoutASpringTrots) {
  const Answer answer = trot(direct_drive_leg(""), "leg.yaml", kOnBench);
  EXPECT_EQ(answer.status, 0) << answer.output;
  EXPECT_EQ(answer.output.find("rigid"), std::string::npos) << answer.output;
}

TEST(RobotCase, AGearTooStiffToOscillateBelowTheControlTrotsAsRigidAndIsNamed) {
  const Answer answer = trot(direct_drive_leg("    spring_stiffness_Nm_rad: 1e4\n"), "leg.yaml", kOnBench);
  EXPECT_EQ(answer.status, 0) << answer.output;
  EXPECT_NE(answer.output.find("rotors oscillate above 100 Hz on the springs of drive: these drives count as rigid"),
            std::string::npos)
      << answer.output;
}

TEST(RobotCase, ASpringOnWhichTheRotorOscillatesSlowlyIsRefusedWithNumbersAndKey) {
  const Answer answer = trot(direct_drive_leg("    spring_stiffness_Nm_rad: 300\n"), "leg.yaml", kOnBench);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.output.find("electric_actuators.drive.spring_stiffness_Nm_rad: 300 lets the rotor oscillate on the "
                               "spring: give at most 29.8, or leave the key out for a drive without a spring; from 895 "
                               "on the drive counts as rigid"),
            std::string::npos)
      << answer.output;
  EXPECT_EQ(answer.output.find("rotor_inertia gear_ratio^2"), std::string::npos) << "a formula: " << answer.output;
}

TEST(RobotCase, AStopTooSoftForTheMotorIsRefusedWithNumbersAndKey) {
  const Answer answer =
      trot(direct_drive_leg("    stops: {stiffness_Nm_rad: 100, damping_Nms_rad: 1}\n"), "leg.yaml", kOnBench);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.output.find("stops.stiffness_Nm_rad = 100 must be at least 1600.71"), std::string::npos)
      << answer.output;
}

TEST(RobotCase, ARobotKnownByItsLimitsTrotsOnTheBench) {
  const Answer answer = trot(read_file(shipped("go1")), "go1.yaml", kOnBench);
  EXPECT_EQ(answer.status, 0) << answer.output;
}

TEST(RobotCase, ARobotKnownByItsLimitsTrotsOnTheGround) {
  const Answer answer = trot(read_file(shipped("go1")), "go1.yaml", {"--dds", "inproc", "--duration", "14"});
  EXPECT_EQ(answer.status, 0) << answer.output;
  EXPECT_NE(answer.output.find("without a fall"), std::string::npos) << answer.output;
}

TEST(RobotCase, LimitsThatAreIncompleteAreRefusedWithWhatIsNeeded) {
  const Answer answer =
      trot(replaced(read_file(shipped("go1")), "    armature_kg_m2: 0.01\n", ""), "go1.yaml", kOnBench);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.output.find("electric_actuators.hip: lacks values: give torque_limit_Nm, speed_limit_rad_s and "
                               "armature_kg_m2"),
            std::string::npos)
      << answer.output;
}

TEST(RobotCase, LimitsBesideAMotorAreRefused) {
  const Answer answer = trot(replaced(read_file(shipped("go1")), "    armature_kg_m2: 0.01\n",
                                      "    armature_kg_m2: 0.01\n    gear_ratio: 6\n"),
                             "go1.yaml", kOnBench);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.output.find("electric_actuators.hip: has limits and a motor's values"), std::string::npos)
      << answer.output;
}

TEST(RobotCase, AUrdfIsRecognisedAndAnsweredWithItsLimits) {
  const Answer answer = trot(
      "<?xml version=\"1.0\"?>\n<!-- made by hand: <robot name=\"old\"> -->\n<robot name=\"dog\">\n"
      "  <link name=\"base\"/>\n"
      "  <joint name=\"imu\" type=\"fixed\"><parent link=\"base\"/></joint>\n"
      "  <joint name=\"hip\" type=\"revolute\">\n    <limit lower=\"-1\" upper=\"1\" effort=\"23.7\" "
      "velocity='30.1'/>\n"
      "  </joint>\n</robot>\n",
      "dog.urdf", kOnBench);
  EXPECT_EQ(answer.status, 2);
  EXPECT_NE(answer.output.find("dog.urdf:3: is a URDF of dog, not a robot file: copy go1.yaml"), std::string::npos)
      << answer.output;
  EXPECT_NE(answer.output.find("\n  hip: torque_limit_Nm: 23.7, speed_limit_rad_s: 30.1"), std::string::npos)
      << answer.output;
}

TEST(RobotCase, OtherDescriptionsAreNamed) {
  for (const auto& [content, name] : std::vector<std::pair<std::string, std::string>>{
           {"\xEF\xBB\xBF<robot name='a'><xacro:include filename='leg.xacro'/></robot>", "is a xacro file of a"},
           {"<sdf version='1.7'><model name='b'/></sdf>", "is an SDF file"},
           {"<mujoco model=\"c\">\n</mujoco>", "is an MJCF file of c"},
           {"<robot name='d'>\n  <link", "is a URDF, not a robot file"},
           {"<html></html>", "is XML, not a robot file"}}) {
    const Answer answer = trot(content, "robot", kOnBench);
    EXPECT_EQ(answer.status, 2);
    EXPECT_NE(answer.output.find(name), std::string::npos) << answer.output;
  }
}

}  // namespace robot_cases
}  // namespace farrier::test
