#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "test_files.hpp"

namespace farrier::robot {
namespace round_trip_test {

// Everything a joint is made of, as bits.
std::string fingerprint(const Joint& j) {
  std::ostringstream text;
  text << std::hexfloat << j.name << ' ' << j.number << ' ' << j.leg << ' ' << j.index_in_leg << ' ';
  const plant::ActuatorParams& a = j.actuator;
  for (const double x : {a.area_a, a.area_b, a.stroke, a.line_volume_m3, a.bulk_modulus_Pa, a.valve_gain,
                         a.valve_current_max_A, a.supply_pressure_Pa, a.return_pressure_Pa, a.piston_mass,
                         a.piston_damping, a.stop_stiffness, a.stop_damping, a.laminar_pressure_Pa, a.line.length_m,
                         a.line.bore_m, a.line.density_kg_m3, a.line.viscosity_Pa_s, a.line.loss_coefficient}) {
    text << x << ' ';
  }
  for (const plant::LoadParams& load : {j.swing_load, j.stance_load}) {
    text << load.mass << ' ' << load.damping << ' ' << load.stiffness << ' ' << load.equilibrium_position << ' ';
  }
  for (const plant::ActiveEffect& effect : j.effects) {
    text << effect.id << ' ';
    for (const double value : effect.values) {
      text << value << ' ';
    }
  }
  for (const control::LowPassParams& f :
       {j.sensors.position, j.sensors.velocity, j.sensors.force, j.sensors.anti_alias}) {
    text << f.cut_off_Hz << ' ' << f.order << ' ' << f.damping << ' ';
  }
  text << j.sensors.oversampling << ' ' << j.sensors.position_step << ' ';
  for (const double q : {j.angle_min_rad, j.angle_max_rad, j.home_angle_rad}) {
    text << q << ' ' << j.linkage.position(q) << ' ' << j.linkage.lever(q) << ' ';
  }
  const control::LqrWeights& w = j.design.weights;
  const control::Normalisation& n = j.normalisation;
  for (const double x : {j.push_limit, j.pull_limit, j.noise.position, j.noise.velocity, j.noise.force, w.integral,
                         w.position, w.velocity, w.force, w.input, w.integral_factor, w.feed_forward_factor, n.position,
                         n.velocity, n.force, n.current_A, j.stiffness_Nm_rad, j.damping_Nms_rad, j.dither_percent}) {
    text << x << ' ';
  }
  const EstimatorParams& e = j.estimator;
  for (const double x : {e.forgetting_factor, e.operating_point_time_constant_s, e.initial_covariance,
                         e.covariance_limit, e.regressor_min, e.stability_limit}) {
    text << x << ' ';
  }
  text << e.bias << e.position << e.phase_memory << ' ' << e.blank_ticks << ' ' << j.dither_hold_ticks << ' ';
  text << static_cast<int>(j.form);
  return text.str();
}

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, PrintedConfigurationLoadsToTheSameRobot) {
  const Robot robot = load_shipped(GetParam());
  const std::string printed = print_config(robot);
  const auto again = load_robot_text(printed, "printed.yaml");
  ASSERT_TRUE(again.ok()) << to_string(again.error());
  EXPECT_EQ(print_config(again.value()), printed);
  EXPECT_EQ(configuration_hash(again.value()), configuration_hash(robot));
  ASSERT_EQ(again.value().joints.size(), robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    EXPECT_EQ(fingerprint(again.value().joints[i]), fingerprint(robot.joints[i]));
  }
  EXPECT_EQ(again.value().plan.body_weight_N, robot.plan.body_weight_N);
  EXPECT_EQ(again.value().plan.gait.hip_height_m, robot.plan.gait.hip_height_m);
  EXPECT_EQ(again.value().loop_delay_realtime, robot.loop_delay_realtime);
  EXPECT_EQ(again.value().estimate_period_ticks, robot.estimate_period_ticks);
}

INSTANTIATE_TEST_SUITE_P(Shipped, RoundTrip, testing::Values("hyq", "fc1d", "fc1d_real"));

TEST(ConfigurationHash, IgnoresCommentsAndOrderButNoValue) {
  const std::string text = text_of("fc1d");
  const auto hash = [](const std::string& yaml) {
    const auto robot = load_robot_text(yaml, "f.yaml");
    EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
    return robot ? configuration_hash(robot.value()) : 0;
  };
  const auto original = hash(text);
  EXPECT_EQ(hash("# another comment\n" + text), original);
  EXPECT_EQ(hash(replaced(text, "{lockstep: 0, realtime: 1}", "{realtime: 1, lockstep: 0}")), original);
  EXPECT_EQ(hash(replaced(text, "period_s: 0.001", "period_s: 1.0e-3")), original);
  EXPECT_NE(hash(replaced(text, "5.5e8 ", "5.500001e8 ")), original);
  EXPECT_NE(hash(replaced(text, "realtime: 1}", "realtime: 2}")), original);
}

TEST(Overrides, ArePartOfTheEffectiveConfigurationAndAreChecked) {
  const Robot robot = load_shipped("hyq", {gait::Pattern::kStand, 2.0});
  EXPECT_EQ(robot.plan.gait.pattern, gait::Pattern::kStand);
  EXPECT_EQ(robot.plan.gait.frequency_Hz, 2.0);
  EXPECT_NE(print_config(robot).find("  pattern: stand\n  frequency_Hz: 2\n"), std::string::npos);
  EXPECT_NE(configuration_hash(robot), configuration_hash(load_shipped("hyq")));
  const auto refused = load_robot(shipped("hyq"), {std::nullopt, 900.0});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(to_string(refused.error()), shipped("hyq") + ": gait.frequency_Hz: 900 is out of range: give 0.05 to 10\n");
}

TEST(Overrides, TakeTheDitherFromEveryJointAndNothingElse) {
  const Robot probed = load_shipped("hyq");
  Robot quiet = load_shipped("hyq", {.pattern = std::nullopt, .frequency_Hz = std::nullopt, .without_dither = true});
  ASSERT_GT(probed.joints.front().dither_percent, 0.0);
  for (const Joint& joint : quiet.joints) {
    EXPECT_EQ(joint.dither_percent, 0.0) << joint.name;
  }
  for (auto& [name, joint] : quiet.file.joints) {
    joint.dither_percent = config::find(probed.file.joints, name)->dither_percent;
  }
  EXPECT_EQ(print_config(quiet), print_config(probed));
}

TEST(Overrides, GiveEveryJointAnotherEstimatorAndEveryControllerAnotherKind) {
  Overrides overrides;
  overrides.estimator = "greybox";
  overrides.controller = control::Kind::kFlowInversion;
  for (const char* name : {"hyq", "fc1d"}) {
    for (const Joint& joint : load_shipped(name, overrides).joints) {
      EXPECT_EQ(joint.estimator.method, estimation::EstimationMethod::kGreyBox) << joint.name;
      EXPECT_EQ(joint.kind, control::Kind::kFlowInversion) << joint.name;
    }
  }
  overrides.estimator = "crystal_ball";
  EXPECT_FALSE(load_robot(shipped("hyq"), overrides).ok());
}

TEST(ParameterTable, CoversTheWholeRobotFile) {
  const std::string table = parameter_table();
  for (const char* path : {"`period_s`", "`supply.supply_pressure_Pa`", "`actuators.<name>.cylinder.bore_m`",
                           "`loads.<name>.stance.mass_kg`", "`gait.duty`", "`estimators.<name>.bias`",
                           "`update_logic.converged_ticks`", "`safety.command_trip_s`"}) {
    EXPECT_NE(table.find(path), std::string::npos) << path;
  }
  EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 100);
}

}  // namespace round_trip_test
}  // namespace farrier::robot
