#include <gtest/gtest.h>

#include "plant/hydraulic_joint.hpp"
#include "robot/joint_model.hpp"
#include "test_files.hpp"

namespace farrier::robot {
namespace effects_by_joint_test {

using plant::effect_info;
using plant::EffectId;

std::string with_effects(const std::string& lines) { return text_without_effects("hyq") + "\neffects:\n" + lines; }

Robot loaded(const std::string& text) {
  auto robot = load_robot_text(text, "hyq.yaml");
  EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
  return robot ? std::move(robot).value() : Robot{};
}

/// Every parameter of an effect in the middle of its range, as a file has it for that joint.
std::string everything_of(const Joint& joint, EffectId id) {
  const plant::Scales scales(joint.actuator, joint.swing_load);
  std::string text = "    " + std::string(effect_info(id).name) + ": {";
  for (const plant::Parameter& p : effect_info(id).parameters) {
    const plant::ParameterRange range = range_of(p, scales);
    text += std::string(&p == effect_info(id).parameters.data() ? "" : ", ") + (joint.rotary ? p.rotary_name : p.name) +
            ": " + config::number_text(range.low + 0.25 * (range.high - range.low));
  }
  return text + "}\n";
}

TEST(JointEffects, AreReadWithDefaultsForWhatIsLeftOut) {
  const Robot robot =
      loaded(with_effects("  lf_kfe:\n"
                          "    valve_deadband: {half_width_A: 2.1e-4}\n"
                          "    load_friction: {coulomb_N: 80, stribeck_velocity_m_s: 0.02}\n"
                          "    spring_hardening: {cubic_N_m3: 1e6}\n"));
  const Joint& joint = *robot.find("lf_kfe");
  ASSERT_EQ(joint.effects.size(), 3u);
  const auto value = [&](const char* effect, const char* parameter) {
    const plant::ActiveEffect* found = plant::find(joint.effects, plant::find_effect(effect));
    return found != nullptr ? plant::parameter_value(*found, parameter) : std::nullopt;
  };
  EXPECT_EQ(value("valve_deadband", "half_width_A"), 2.1e-4);
  EXPECT_EQ(value("load_friction", "coulomb_N"), 80.0);
  EXPECT_EQ(value("load_friction", "coulomb_Nm"), 80.0) << "by its other name too";
  EXPECT_EQ(value("load_friction", "breakaway_ratio"), 1.3);
  EXPECT_EQ(value("load_friction", "stribeck_velocity_m_s"), 0.02);
  EXPECT_EQ(value("spring_hardening", "slack_position_m"), 0.5 * joint.actuator.stroke) << "no spring: mid-stroke";
  EXPECT_EQ(value("load_friction", "half_width_A"), std::nullopt);
  EXPECT_EQ(value("valve_bias", "current_A"), std::nullopt);
  EXPECT_TRUE(robot.find("rf_kfe")->effects.empty());
}

TEST(JointEffects, OfAKindOfJointAreThoseOfAllLegsUnlessAJointHasItsOwn) {
  const Robot robot =
      loaded(with_effects("  kfe:\n    valve_deadband: {half_width_A: 2e-4}\n    valve_bias: {current_A: 1e-5}\n"
                          "  rf_kfe:\n    valve_deadband: {half_width_A: 3e-4}\n"));
  for (const Joint& joint : robot.joints) {
    ASSERT_EQ(joint.effects.size(), joint.name.ends_with("kfe") ? 2u : 0u) << joint.name;
    const auto* overlap = plant::find(joint.effects, plant::find_effect("valve_deadband"));
    if (overlap != nullptr) {
      EXPECT_EQ(overlap->values[0], joint.name == "rf_kfe" ? 3e-4 : 2e-4) << joint.name;
    }
  }
  EXPECT_EQ(loaded(print_config(robot)).find("rf_kfe")->effects, robot.find("rf_kfe")->effects);
}

TEST(JointEffects, AreNoneInRobotsThatSayNothingOfThem) {
  for (const char* name : {"hyq", "fc1d", "hexapod"}) {
    const Robot robot = load_shipped(name, {.without_effects = true});
    EXPECT_EQ(print_config(robot).find("effects:"), std::string::npos);
    for (const Joint& joint : robot.joints) {
      EXPECT_TRUE(joint.effects.empty());
      EXPECT_EQ(joint.rotary, joint.name.ends_with("haa"));
    }
  }
}

// All 22 on a cylinder and on a motor. A new effect gets its place in files without a change here.
TEST(JointEffects, CanAllBeSaidAndComeBackFromThePrintedConfiguration) {
  const Robot plain = load_shipped("hyq", {.without_effects = true});
  for (const char* name : {"lf_hfe", "rh_haa"}) {
    for (EffectId id = 0; id < plant::kEffectCount; ++id) {
      const std::string lines = "  " + std::string(name) + ":\n" + everything_of(*plain.find(name), id);
      const Robot robot = loaded(with_effects(lines));
      ASSERT_EQ(robot.joints.size(), plain.joints.size()) << lines;
      ASSERT_EQ(robot.find(name)->effects.size(), 1u) << lines;
      EXPECT_EQ(robot.find(name)->effects[0].id, id);
      const std::string printed = print_config(robot);
      const Robot again = loaded(printed);
      EXPECT_EQ(print_config(again), printed);
      EXPECT_EQ(again.find(name)->effects, robot.find(name)->effects) << lines;
      EXPECT_EQ(again.find(name)->stance_load.mass, robot.find(name)->stance_load.mass);
      EXPECT_NE(configuration_hash(robot), configuration_hash(plain));
    }
  }
}

TEST(JointEffects, PrintTheirDefaults) {
  const std::string printed = print_config(loaded(with_effects("  lf_haa:\n    end_stop: {inset_rad: 0.1}\n")));
  const auto at =
      printed.find("effects:\n  \"lf_haa\":\n    end_stop:\n      inset_rad: 0.1\n      stiffness_Nm_rad: ");
  EXPECT_NE(at, std::string::npos) << printed;
  EXPECT_EQ(printed.find("inset_m:"), std::string::npos);
}

TEST(JointEffects, ThatAreOtherLoadsChangeWhatIsDesignedFor) {
  const Robot plain = load_shipped("hyq", {.without_effects = true});
  const Robot robot = loaded(
      with_effects("  lf_kfe:\n    load_mass: {mass_kg: 4}\n    load_damping: {damping_Ns_m: 300}\n"
                   "    load_stiffness: {stiffness_N_m: 2000}\n  lf_haa:\n    load_mass: {inertia_kg_m2: 0.5}\n"));
  const Joint& joint = *robot.find("lf_kfe");
  EXPECT_DOUBLE_EQ(joint.swing_load.mass, 4.0);
  EXPECT_DOUBLE_EQ(joint.stance_load.mass, 51.5);
  EXPECT_DOUBLE_EQ(joint.swing_load.damping, 300.0);
  EXPECT_DOUBLE_EQ(joint.stance_load.damping, 300.0);
  EXPECT_DOUBLE_EQ(joint.swing_load.stiffness, 2000.0);
  EXPECT_DOUBLE_EQ(joint.swing_load.equilibrium_position, 0.5 * joint.actuator.stroke);
  EXPECT_DOUBLE_EQ(robot.plan.legs[0].joints[2].swing_load.mass, 4.0) << "feed-forward knows it";
  EXPECT_EQ(robot.find("lf_haa")->swing_load.mass, robot.find("lf_haa")->stance_load.mass);
  EXPECT_NE(robot.find("lf_haa")->swing_load.mass, plain.find("lf_haa")->swing_load.mass);
  EXPECT_EQ(robot.find("rf_kfe")->swing_load.mass, 2.5);
}

TEST(JointEffects, OfTheEndsOfTheirRangesAreTaken) {
  const Joint joint = *load_shipped("hyq", {.without_effects = true}).find("lf_kfe");
  const plant::Scales scales(joint.actuator, joint.swing_load);
  for (EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::Parameter& p = effect_info(id).parameters[0];
    for (const double fitted : {p.low, p.high}) {
      // Multiples of a joint's size are another program's rounded products.
      const double rounding = scales.of(p.scale) == 1.0 ? 0.0 : 1e-12;
      const double last_digits = scales.value(p, fitted) * (1.0 + rounding);
      loaded(with_effects("  lf_kfe:\n    " + std::string(effect_info(id).name) + ": {" + p.name + ": " +
                          config::number_text(last_digits) + "}\n"));
    }
  }
}

struct Mistake {
  const char* lines;
  const char* at;  ///< what the line of the problem begins with
  const char* problem;
};

class JointEffectsMistake : public testing::TestWithParam<Mistake> {};

TEST_P(JointEffectsMistake, IsReportedWithItsLineAndRemedy) {
  const std::string text = with_effects(GetParam().lines);
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(text.rfind(GetParam().at)), '\n');
  EXPECT_EQ(to_string(robot.error()), "hyq.yaml:" + std::to_string(line) + ": effects." + GetParam().problem + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, JointEffectsMistake,
    testing::Values(
        Mistake{"  lf_kne:\n    valve_bias: {current_A: 1e-4}\n", "  lf_kne",
                "lf_kne: is neither a joint of a leg nor a section of joints: did you mean lf_kfe?"},
        Mistake{"  lf_kfe:\n    valve_dedband: {half_width_A: 1e-4}\n", "    valve_dedband",
                "lf_kfe.valve_dedband: is not a known parameter: did you mean valve_deadband?"},
        Mistake{"  lf_kfe:\n    valve_deadband: {half_widht_A: 1e-4, half_width_A: 1e-4}\n", "    valve_dead",
                "lf_kfe.valve_deadband.half_widht_A: is not a known parameter: did you mean half_width_A?"},
        Mistake{"  lf_kfe:\n    valve_deadband: {half_width_mA: 0.1, half_width_A: 1e-4}\n", "    valve_dead",
                "lf_kfe.valve_deadband.half_width_mA: is given in A: half_width_A"},
        Mistake{"  lf_kfe:\n    valve_deadband: {half_width_A: 0.008}\n", "    valve_dead",
                "lf_kfe.valve_deadband.half_width_A: 0.008 is out of this joint's range: give 0 to 0.004"},
        Mistake{"  lf_kfe:\n    valve_deadband: {half_width_A: wide}\n", "    valve_dead",
                "lf_kfe.valve_deadband.half_width_A: wide is not a number: give a number"},
        Mistake{"  lf_kfe:\n    load_friction: {coulomb_N: 80, breakaway_ratio: 3}\n", "    load_fri",
                "lf_kfe.load_friction.breakaway_ratio: 3 is out of range: give 1 to 2.5"},
        Mistake{"  lf_kfe:\n    load_friction: {coulomb_N: 80, presliding_m: 2e-8}\n", "    load_fri",
                "lf_kfe.load_friction.presliding_m: 2e-08 makes bristles stiffer than the shortest step of the "
                "simulation allows at this joint's full speed: give at least 5.3e-06"},
        Mistake{"  lf_kfe:\n    load_friction: {coulomb_N: 80, bristle_damping_Ns_m: 300}\n", "    load_fri",
                "lf_kfe.load_friction.bristle_damping_Ns_m: 300 gives energy back at this joint's full speed: give at "
                "most 262.82"},
        Mistake{"  lf_kfe:\n    input_delay: {}\n", "    input",
                "lf_kfe.input_delay.delay_s: is missing: give 0 to 0.03 (The delay.)"},
        Mistake{"  lf_kfe:\n    external_force: {torque_Nm: 5, force_N: 3}\n", "    external",
                "lf_kfe.external_force.torque_Nm: is for a rotary motor: of this joint it is force_N"},
        Mistake{"  lf_haa:\n    external_force: {force_N: 5}\n", "    external",
                "lf_haa.external_force.force_N: is for a cylinder: of this joint it is torque_Nm"},
        Mistake{"  lf_haa: {}\n", "  lf_haa", "lf_haa: is empty: name an effect, or leave the joint out"},
        Mistake{"  lf_kfe: [valve_bias]\n", "  lf_kfe", "lf_kfe: is a list: give a group of parameters"}));

// A stance load with less damping than swing has: what swing lost it cannot lose.
TEST(JointEffects, ThatLeaveNoLoadInStanceAreRefused) {
  const std::string text =
      replaced(with_effects("  lf_kfe:\n    load_damping: {damping_Ns_m: 50}\n"),
               "stance: {mass_kg: 50, damping_Ns_m: 500}", "stance: {mass_kg: 50, damping_Ns_m: 100}");
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  EXPECT_NE(to_string(robot.error()).find("effects.lf_kfe: leave no load in swing or stance: load: damping = -350"),
            std::string::npos)
      << to_string(robot.error());
}

TEST(JointEffects, StandInTheTableOfParameters) {
  const std::string table = parameter_table();
  for (EffectId id = 0; id < plant::kEffectCount; ++id) {
    for (const plant::Parameter& p : effect_info(id).parameters) {
      for (const char* name : {p.name, p.rotary_name}) {
        const std::string path = "`effects.<name>." + std::string(effect_info(id).name) + "." + name + "`";
        EXPECT_NE(table.find(path), std::string::npos) << path;
      }
    }
  }
}

}  // namespace effects_by_joint_test
}  // namespace farrier::robot
