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
  for (const char* name : {"hexapod", "fc1d"}) {
    for (const Joint& joint : load_shipped(name).joints) {
      EXPECT_TRUE(joint.effects.empty());
      EXPECT_EQ(joint.actuator.line.length_m, 0.0);
      EXPECT_EQ(joint.sensors.oversampling, 1);
      EXPECT_EQ(joint.sensors.velocity.cut_off_Hz, 0.0);
    }
  }
}

TEST(RobotEffects, OfTheRealRigAreThoseOfItsExperiments) {
  const Robot real = load_shipped("fc1d_real");
  ASSERT_EQ(real.joints.size(), 1u);
  const Joint& joint = real.joints[0];
  const auto value = [&](plant::EffectId id, const char* parameter) {
    const plant::ActiveEffect* found = plant::find(joint.effects, id);
    return found == nullptr ? std::nullopt : plant::parameter_value(*found, parameter);
  };
  EXPECT_EQ(value(plant::effect_id<plant::ValveDynamics>(), "natural_frequency_rad_s"), 1570.0);
  EXPECT_EQ(value(plant::effect_id<plant::ValveDynamics>(), "damping"), 0.5);
  EXPECT_EQ(value(plant::effect_id<plant::ValveDeadband>(), "half_width_A"), 6e-5);
  EXPECT_EQ(value(plant::effect_id<plant::LoadFriction>(), "coulomb_N"), 10.0);
  EXPECT_EQ(value(plant::effect_id<plant::LoadFriction>(), "breakaway_ratio"), 1.3);
  EXPECT_EQ(value(plant::effect_id<plant::LoadFriction>(), "stribeck_velocity_m_s"), 0.01);
  EXPECT_EQ(joint.effects.size(), 3u);
  EXPECT_EQ(joint.actuator.line.length_m, 0.6);
  EXPECT_EQ(joint.actuator.line.bore_m, 0.0038);
  for (const plant::LoadParams& load : {joint.swing_load, joint.stance_load}) {
    const plant::State rest = plant::equilibrium(joint.actuator, load, 0.04, 0.0);
    const auto plant = plant::HydraulicJoint::create(joint.actuator, load, rest,
                                                     plant::HydraulicJoint::kDefaultTolerance, joint.effects);
    ASSERT_TRUE(plant.ok());
    const plant::FrictionParams& guide = plant.value().load().friction;
    EXPECT_EQ(guide.breakaway, 13.0);
    EXPECT_EQ(guide.presliding, 1e-5);
  }
  EXPECT_EQ(joint.sensors.velocity.order, 2);
  EXPECT_EQ(joint.sensors.velocity.cut_off_Hz, 20.0);
  EXPECT_EQ(joint.sensors.force.cut_off_Hz, 100.0);
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
  EXPECT_EQ(real.noise.force, ideal.noise.force);
}

TEST(RobotEffects, AreRefusedWithTheirLineWhereNoneCanHaveThem) {
  const std::string text = text_of("fc1d");
  EXPECT_EQ(
      problem_of(replaced(text, kNoise, std::string(kNoise) + "      sensors: {velocity_filter_Hz: 480}\n")),
      "f.yaml:35: actuators.cylinder.cylinder.sensors.velocity_filter_Hz: is 480, but a filter sampled at 1000 Hz "
      "reaches up to 450: give less, or 0 for none\n");
  EXPECT_NE(problem_of(replaced(text, kNoise, std::string(kNoise) + "      sensors: {pressure_filter_Hz: 100}\n"))
                .find("f.yaml:35: actuators.cylinder.cylinder.sensors.pressure_filter_Hz: is not a known parameter"),
            std::string::npos);
  EXPECT_NE(problem_of(replaced(text, kVolume, "    lines: {length_m: 3, bore_m: 0.0038}\n" + std::string(kVolume)))
                .find("line: volume"),
            std::string::npos);
  EXPECT_EQ(problem_of(replaced(text, kNoise,
                                std::string(kNoise) + "      sensors: {oversampling: 8, anti_alias_Hz: 1500}\n")),
            "");
}

// The spelling of before, with place and remedy.
TEST(RobotEffects, AreRefusedInSectionsOfPartsWithTheKeyThatReplacesThem) {
  const std::string text = text_of("fc1d");
  EXPECT_EQ(problem_of(replaced(text, kValve, std::string(kValve) + "    deadband_percent: 0.6\n")),
            "f.yaml:19: valves.moog.deadband_percent: is no longer a parameter: give "
            "effects.<joint>.valve_deadband.half_width_A, in A\n");
  EXPECT_EQ(problem_of(replaced(text, kValve, std::string(kValve) + "    spool: {damping: 0.7, on: false}\n")),
            "f.yaml:19: valves.moog.spool: is no longer a parameter: give effects.<joint>.valve_dynamics with "
            "natural_frequency_rad_s and damping\n");
  const std::string friction = problem_of(replaced(text, "      mass_kg: 2.5                  # A.2\n",
                                                   "      friction: {coulomb_N: 40, static_N: 60}\n"
                                                   "      mass_kg: 2.5\n"));
  EXPECT_NE(friction.find("loads.cart.swing.friction: is no longer a parameter: give effects.<joint>.load_friction"),
            std::string::npos)
      << friction;
}

}  // namespace effects_test
}  // namespace farrier::robot
