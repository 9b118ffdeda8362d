#include <gtest/gtest.h>

#include "plant/hydraulic_joint.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace effects_test {

const char* const kValve = "    current_max_A: 0.01           # A.1\n";
const char* const kVolume = "    line_volume_m3: 6.8047e-6";
const char* const kNoise = "      noise: {position_m: 2e-6, velocity_m_s: 1.5e-3, force_N: 1}  # as HyQ's\n";

std::string problem_of(const std::string& text) {
  const auto robot = load_robot_text(text, "f.yaml");
  return robot.ok() ? "" : to_string(robot.error());
}

TEST(RobotEffects, AreNoneUnlessTheFileAsksForThem) {
  for (const char* name : {"hyq", "fc1d"}) {
    for (const Joint& joint : load_shipped(name).joints) {
      EXPECT_FALSE(joint.actuator.spool.on);
      EXPECT_EQ(joint.actuator.valve_deadband_A, 0.0);
      EXPECT_EQ(joint.actuator.line.length_m, 0.0);
      EXPECT_EQ(joint.swing_load.friction.coulomb, 0.0);
      EXPECT_EQ(joint.stance_load.friction.breakaway, 0.0);
      EXPECT_EQ(joint.sensors.oversampling, 1);
      EXPECT_EQ(joint.sensors.velocity.cut_off_Hz, 0.0);
    }
  }
}

TEST(RobotEffects, OfTheRealRigAreThoseOfItsExperiments) {
  const Robot real = load_shipped("fc1d_real");
  ASSERT_EQ(real.joints.size(), 1u);
  const Joint& joint = real.joints[0];
  EXPECT_EQ(joint.actuator.valve_deadband_A, 0.6 / 100.0 * 0.01);
  EXPECT_FALSE(joint.actuator.spool.on) << "known, and not switched on: see the file";
  EXPECT_EQ(joint.actuator.spool.natural_frequency_rad_s, 1570.0);
  EXPECT_EQ(joint.actuator.spool.damping, 0.5);
  EXPECT_EQ(joint.actuator.line.length_m, 0.6);
  EXPECT_EQ(joint.actuator.line.bore_m, 0.0038);
  for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
    EXPECT_EQ(load.friction.coulomb, 40.0);
    EXPECT_EQ(load.friction.breakaway, 60.0);
    EXPECT_EQ(load.friction.stribeck_velocity, 0.01);
    const plant::State rest = plant::equilibrium(joint.actuator, load, 0.04, 0.0);
    EXPECT_TRUE(plant::HydraulicJoint::create(joint.actuator, load, rest));
  }
  EXPECT_EQ(joint.sensors.velocity.cut_off_Hz, 100.0);
  EXPECT_EQ(joint.sensors.velocity.order, 2);
}

// Beside the effects it is the rig: all that control is designed by stays.
TEST(RobotEffects, AreAllThatTellsTheRealRigFromTheIdealOne) {
  const Joint real = load_shipped("fc1d_real").joints.at(0);
  const Joint ideal = load_shipped("fc1d").joints.at(0);
  EXPECT_EQ(real.name, ideal.name);
  EXPECT_EQ(real.actuator.valve_gain, ideal.actuator.valve_gain);
  EXPECT_EQ(real.actuator.line_volume_m3, ideal.actuator.line_volume_m3);
  EXPECT_EQ(real.actuator.bulk_modulus_Pa, ideal.actuator.bulk_modulus_Pa);
  EXPECT_EQ(real.swing_load.mass, ideal.swing_load.mass);
  EXPECT_EQ(real.stance_load.damping, ideal.stance_load.damping);
  EXPECT_EQ(real.design.weights.integral_factor, ideal.design.weights.integral_factor);
  EXPECT_EQ(real.noise.velocity, ideal.noise.velocity);
}

// Torque r F, angle x / r: friction scales with r, speed and way with 1 / r, and so do steps of a position sensor.
TEST(RobotEffects, OfAMotorAreItsCylindersSeenThroughTheLever) {
  const std::string text = text_of("hyq");
  const auto dry = replaced(text, "swing: {mass_kg: 2.5, damping_Ns_m: 500",
                            "swing: {friction: {coulomb_N: 10, static_N: 15}, mass_kg: 2.5, damping_Ns_m: 500");
  const auto robot = load_robot_text(dry, "hyq.yaml");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  const Joint& cylinder = *robot.value().find("lf_hfe");
  const Joint& motor = *robot.value().find("lf_haa");
  const double lever = motor.swing_load.friction.coulomb / cylinder.swing_load.friction.coulomb;
  EXPECT_GT(lever, 0.0);
  EXPECT_LT(lever, 0.2);
  EXPECT_DOUBLE_EQ(motor.swing_load.damping, cylinder.swing_load.damping * lever * lever);
  EXPECT_DOUBLE_EQ(motor.swing_load.friction.stribeck_velocity, cylinder.swing_load.friction.stribeck_velocity / lever);
  EXPECT_DOUBLE_EQ(motor.swing_load.friction.presliding, cylinder.swing_load.friction.presliding / lever);
}

TEST(RobotEffects, AreRefusedWithTheirLineWhereNoneCanHaveThem) {
  const std::string text = text_of("fc1d");
  EXPECT_EQ(problem_of(replaced(text, kNoise, std::string(kNoise) + "      sensors: {velocity_filter_Hz: 480}\n")),
            "f.yaml:35: actuators.cylinder.cylinder.sensors.velocity_filter_Hz: is 480, but a filter sampled at 1000 Hz "
            "reaches up to 450: give less, or 0 for none\n");
  EXPECT_NE(problem_of(replaced(text, kVolume, "    lines: {length_m: 3, bore_m: 0.0038}\n" + std::string(kVolume)))
                .find("line: volume"),
            std::string::npos);
  EXPECT_NE(problem_of(replaced(text, kValve, std::string(kValve) + "    deadband_percent: 51\n")).find("out of range"),
            std::string::npos);
  EXPECT_NE(problem_of(replaced(text, "      mass_kg: 2.5                  # A.2\n",
                                "      friction: {coulomb_N: 40, static_N: 30}\n      mass_kg: 2.5\n"))
                .find("must not be below coulomb_N"),
            std::string::npos);
  EXPECT_EQ(problem_of(replaced(text, kNoise, std::string(kNoise) +
                                                  "      sensors: {oversampling: 8, anti_alias_Hz: 1500}\n")),
            "");
}

TEST(RobotEffects, SwitchedOffSpoolsKeepTheirNumbers) {
  const auto robot = load_robot_text(
      replaced(text_of("fc1d"), kValve, std::string(kValve) + "    spool: {damping: 0.7, on: false}\n"), "f.yaml");
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_FALSE(robot.value().joints[0].actuator.spool.on);
  EXPECT_EQ(robot.value().joints[0].actuator.spool.damping, 0.7);
}

}  // namespace effects_test
}  // namespace farrier::robot
