#include <gtest/gtest.h>

#include <algorithm>

#include "test_files.hpp"

namespace farrier::robot {
namespace mistakes_test {

// One change to hyq.yaml and the one problem it must cause, at the line of the change.
struct Mistake {
  const char* from;
  const char* to;
  const char* problem;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.to; }

class RobotFileMistake : public testing::TestWithParam<Mistake> {};

TEST_P(RobotFileMistake, IsReportedWithItsLineAndRemedy) {
  const std::string text = replaced(text_of("hyq"), GetParam().from, GetParam().to);
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  const int line = line_of(text, GetParam().to);
  EXPECT_EQ(to_string(robot.error()),
            "hyq.yaml:" + std::to_string(line) + ": " + std::string(GetParam().problem) + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, RobotFileMistake,
    testing::Values(
        Mistake{"stance: {mass_kg: 50,", "stance: {mass_kg: -3,",
                "loads.bench.stance.mass_kg: -3 is out of range: give 0.01 to 1000"},
        Mistake{"supply_pressure_Pa: 160e5", "supply_pressure_bar: 160",
                "supply.supply_pressure_bar: is given in Pa: supply_pressure_Pa"},
        Mistake{"return_pressure_Pa: 0 ", "return_pressure_Pa: .inf ",
                "supply.return_pressure_Pa: .inf is not a finite number: give 0 to 1e+07"},
        Mistake{"  pattern: trot", "  pattern: gallop", "gait.pattern: gallop is not known: give trot or stand"},
        Mistake{"  duty: 0.65", "  dutty: 0.65", "gait.dutty: is not a known parameter: did you mean duty?"},
        Mistake{"retracted_length_m: 0.281\n  kfe:", "retracted_length_m: nine\n  kfe:",
                "linkages.hfe.triangle.retracted_length_m: nine is not a number: give 0.001 to 20"},
        Mistake{"rh_hfe: hfe, rh_kfe: kfe", "rh_hfe: hfe, lf_kfe: kfe",
                "legs.rh.joints.lf_kfe: is the name of a joint of leg lf too: rename one"},
        Mistake{"rh_kfe: kfe", "rh_kfe: knee", "legs.rh.joints.rh_kfe: knee is not one of joints: haa, hfe, kfe"},
        Mistake{"rh_hfe: hfe, rh_kfe: kfe", "rh_hfe: hfe",
                "legs.rh.joints: has 2 joints: give HAA, HFE, KFE, or the one joint of a rig"},
        Mistake{"rh_haa: haa, rh_hfe: hfe,", "rh_hfe: hfe, rh_haa: haa,",
                "legs.rh.joints.rh_haa: has the whole leg as its load: only the first of three joints can"},
        Mistake{"damping_like: bench", "damping_like: leg",
                "loads.leg.leg_about_haa.damping_like: leg has no swing load"},
        Mistake{"like_cylinder: cylinder", "like_cylinder: haa_motor",
                "actuators.haa_motor.rotary_motor.like_cylinder: haa_motor is not a cylinder"},
        Mistake{"lever_joints: [hfe, kfe]", "lever_joints: [haa, kfe]",
                "actuators.haa_motor.rotary_motor.lever_joints: haa has no cylinder"},
        Mistake{"    load: leg", "    load: bench",
                "joints.haa.load: bench is for a cylinder: a rotary motor takes one with leg_about_haa"},
        Mistake{"    linkage: haa", "    linkage: kfe",
                "joints.haa.linkage: kfe is for a cylinder: a motor takes a direct one"},
        Mistake{"rod_m: 0.010 ", "rod_m: 0.020 ", "actuators.cylinder.cylinder.rod_m: must be below bore_m"},
        Mistake{"angle_min_rad: -1.2  ", "angle_min_rad: -1.3  ",
                "joints.haa.angle_min_rad: -1.3 puts actuator haa_motor at -0.10000000000000009, outside its "
                "stroke: 0 to 1.7467"},
        Mistake{"home_angle_rad: 1.5", "home_angle_rad: -1.5",
                "joints.kfe.home_angle_rad: must lie between angle_min_rad and angle_max_rad"},
        Mistake{"stance_lead_s: 0.010", "stance_lead_s: 0.04 ",
                "safety.stance_lead_s: is 0.04, but a touchdown is announced 0.04 s ahead: give less, or more "
                "gait.announce_ticks"},
        Mistake{"stance_lead_s: 0.010", "stance_lead_s: 0.2",
                "safety.stance_lead_s: 0.2 is out of range: give 0 to 0.1"},
        Mistake{"body_mass_kg: 75", "body_mass_kg: 25",
                "variation.body_mass_kg: is 25, but the legs alone weigh 25.796 kg: give the mass of the whole robot"},
        Mistake{"supply_factor: [0.7, 1.3]", "supply_factor: [1.3, 0.7]",
                "variation.supply_factor: is no interval: give two numbers, the lower one first"},
        Mistake{"friction_factor: [1, 5]", "friction_factor: [1]",
                "variation.friction_factor: is no interval: give two numbers, the lower one first"},
        Mistake{"angle_max_rad: 0.8726646 ", "angle_max_rad: -1.3 ",
                "joints.hfe.angle_max_rad: must be above angle_min_rad"},
        Mistake{"angle_max_rad: 0.8726646 ", "angle_max_rad: 1.5 ",
                "joints.hfe.angle_max_rad: folds linkage hfe beyond its dead centre"}));

TEST(RobotFileMistakes, AreAllListedAtOnce) {
  std::string text = text_of("hyq");
  text = replaced(text, "bore_m: 0.016 ", "bore_mm: 16 ");
  text = replaced(text, "stance: {mass_kg: 50,", "stance: {mass_kg: -3,");
  text = replaced(text, "  duty: 0.65", "  duty: most");
  text = replaced(text, "    form: compliant  ", "    form: stiff  ");
  text = replaced(text, "  lf: {front: true, left: true, phase_offset: 0,", "  lf: {front: 1, phase_offset: 1,");
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  const auto line = [&](const char* what) { return "hyq.yaml:" + std::to_string(line_of(text, what)) + ": "; };
  EXPECT_EQ(to_string(robot.error()),
            line("bore_mm") + "actuators.cylinder.cylinder.bore_mm: is given in m: bore_m\n" + line("mass_kg: -3") +
                "loads.bench.stance.mass_kg: -3 is out of range: give 0.01 to 1000\n" + line("form: stiff") +
                "controllers.torque.form: stiff is not known: give full_state or compliant\n" + line("front: 1") +
                "legs.lf.front: 1 is neither true nor false: give one of them\n" + line("front: 1") +
                "legs.lf.phase_offset: 1 is out of range: give 0 to 0.999999\n" + line("front: 1") +
                "legs.lf.left: is missing: give true or false (Left or right.)\n" + line("duty: most") +
                "gait.duty: most is not a number: give 0.05 to 0.95\n");
}

TEST(RobotFileMistakes, IncludeAGaitTheLegsCannotWalk) {
  const std::string text = replaced(text_of("hyq"), "step_length_m: 0.172", "step_length_m: 1.9");
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  ASSERT_EQ(robot.error().size(), 1u) << to_string(robot.error());
  EXPECT_EQ(robot.error()[0].where, "gait");
  EXPECT_EQ(robot.error()[0].line, line_of(text, "\ngait:") + 1);
  EXPECT_NE(robot.error()[0].message.find("leaves the leg's reach"), std::string::npos);
}

TEST(RobotFileMistakes, IncludeStopsTooSoftForTheSupply) {
  const std::string text = replaced(text_of("hyq"), "stiffness_N_m: 2e7", "stiffness_N_m: 2e5");
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  EXPECT_EQ(robot.error()[0].where, "actuators.cylinder") << to_string(robot.error());
}

TEST(RobotFileMistakes, IncludeAFileThatIsNotThere) {
  const auto robot = load_robot(shipped("no_such_robot"));
  ASSERT_FALSE(robot.ok());
  EXPECT_EQ(to_string(robot.error()),
            shipped("no_such_robot") + ": cannot be read: check the path and its permissions\n");
}

}  // namespace mistakes_test
}  // namespace farrier::robot
