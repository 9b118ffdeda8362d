// The body behind sim_bridge: hinges seen through linkages, force references as commands.

#include <gtest/gtest.h>

#include "sim_bridge/body_robot.hpp"
#include "sim_bridge/simulated_robot.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/robot/test_files.hpp"
#include "world/scene_file.hpp"

namespace farrier::sim_bridge {
namespace body_robot_test {

robot::Robot quiet_hyq() {
  robot::Robot hyq = robot::load_shipped("hyq");
  for (robot::Joint& joint : hyq.joints) {
    joint.noise = {};
  }
  return hyq;
}

TEST(BodyRobot, BeginsInTheHomePoseInTheCoordinatesOfItsActuators) {
  const robot::Robot hyq = quiet_hyq();
  const auto body = simulated_body(hyq, "", 1, true).value();
  ASSERT_EQ(body->joints(), hyq.joints.size());
  EXPECT_TRUE(body->takes_forces());
  for (const robot::Joint& joint : hyq.joints) {
    const signals::JointSensors sensors = body->sample(joint.number);
    EXPECT_EQ(sensors.joint, joint.number);
    EXPECT_NEAR(sensors.position_m_or_rad, joint.linkage.position(joint.home_angle_rad), 1e-12) << joint.name;
  }
  ASSERT_TRUE(body->truth());
  ASSERT_TRUE(body->imu());
}

// A piston's force turns its hinge as the torque does that it makes at the lever.
TEST(BodyRobot, TurnsAForceIntoATorqueAtTheLever) {
  const robot::Robot hyq = quiet_hyq();
  const auto body = simulated_body(hyq, "", 1, true).value();
  const robot::Joint& knee = *hyq.find("lf_kfe");
  std::vector<double> forces(body->joints(), 0.0);
  forces[knee.number] = 500.0;
  ASSERT_TRUE(body->advance(forces));
  EXPECT_NEAR(body->sample(knee.number).force_N_or_Nm, 500.0, 1.0);
  EXPECT_NE(body->sample(knee.number).velocity_m_s_or_rad_s, 0.0);
}

TEST(BodyRobot, FallsByItsWeightWithoutForces) {
  const robot::Robot hyq = quiet_hyq();
  const auto body = simulated_body(hyq, "", 1, true).value();
  const double height_m = body->truth()->position_m[2];
  const std::vector<double> none(body->joints(), 0.0);
  for (int tick = 0; tick < 300; ++tick) {
    ASSERT_TRUE(body->advance(none));
  }
  EXPECT_LT(body->truth()->position_m[2], height_m - 0.1);
  EXPECT_EQ(body->truth()->tick, 300);
}

TEST(BodyRobot, AdvanceDoesNotAllocate) {
  const robot::Robot hyq = robot::load_shipped("hyq");
  const auto body = simulated_body(hyq, "", 1, true).value();
  const std::vector<double> none(body->joints(), 0.0);
  ASSERT_TRUE(body->advance(none));
  const test::AllocationGuard guard;
  for (int tick = 0; tick < 20; ++tick) {
    body->advance(none);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(BodyRobot, RefusesARobotWithoutATrunkAndASceneThatIsNotThere) {
  EXPECT_NE(simulated_body(robot::load_shipped("fc1d"), "", 1, true).error().message.find("body.trunk"),
            std::string::npos);
  EXPECT_NE(simulated_body(robot::load_shipped("hyq"), "/nowhere.yaml", 1, true).error().message.find("/nowhere.yaml"),
            std::string::npos);
}

TEST(BodyRobot, SamplesItsSupplyEveryTenTicksAsMeansOfItsFlows) {
  const robot::Robot hyq = robot::load_shipped("hyq", {.pattern = {}, .frequency_Hz = {}, .on_ground = true});
  BodyRobot body = BodyRobot::create(hyq, {}, 1, false).value();
  ASSERT_NE(body.supply_state(), nullptr);
  EXPECT_EQ(body.supply_state()->tick, 0);
  EXPECT_EQ(body.supply_state()->pressure_Pa, 160e5);
  const std::vector<double> shut(body.joints(), 0.0);
  for (int tick = 1; tick <= 100; ++tick) {
    ASSERT_TRUE(body.advance(shut));
    EXPECT_EQ(body.supply_state()->tick, tick - tick % 10);
  }
  const signals::SupplyState& state = *body.supply_state();
  EXPECT_NEAR(state.pump_flow_m3_s, hyq.supply->pump_flow_m3_s, 1e-12);
  EXPECT_NEAR(state.leakage_flow_m3_s, 160e5 * hyq.supply->null_leakage_m3_s_Pa, 1e-8);
  EXPECT_NEAR(state.power_W, 160e5 * hyq.supply->pump_flow_m3_s, 5.0);
  EXPECT_NEAR(state.pump_J, 0.1 * state.power_W, 1.0);
  EXPECT_NEAR(state.relief_flow_m3_s, state.pump_flow_m3_s - state.leakage_flow_m3_s - state.flow_m3_s, 1e-6);
}

TEST(BodyRobot, TellsThePressuresInItsActuatorsAndFindsTheWorkOfItsPumpAgain) {
  const robot::Robot hyq = robot::load_shipped("hyq", {.pattern = {}, .frequency_Hz = {}, .on_ground = true});
  BodyRobot body = BodyRobot::create(hyq, {}, 1, false).value();
  EXPECT_EQ(body.supply_truth().value().pump_J, 0.0);
  const std::vector<double> shut(body.joints(), 0.0);
  for (int tick = 1; tick <= 100; ++tick) {
    ASSERT_TRUE(body.advance(shut));
  }
  const signals::SupplyTruth truth = body.supply_truth().value();
  EXPECT_EQ(truth.tick, 100);
  EXPECT_EQ(truth.pump_J, body.supply_state()->pump_J);
  for (std::size_t i = 0; i < body.joints(); ++i) {
    trace::TraceRow row;
    body.describe(i, row);
    EXPECT_EQ(truth.pressure_a_Pa[i], row.pressure_a_Pa);
    EXPECT_EQ(truth.pressure_b_Pa[i], row.pressure_b_Pa);
    EXPECT_GT(truth.pressure_a_Pa[i] + truth.pressure_b_Pa[i], 1e5);
  }
  const world::EnergyAudit audit = world::audit_in(truth);
  EXPECT_LT(std::abs(audit.residual_J()), 0.01 * audit.pump_J);
}

TEST(BodyRobot, HasNoSupplyWithIdealJointsOrOnABench) {
  const robot::Robot hyq = robot::load_shipped("hyq");
  EXPECT_FALSE(simulated_body(hyq, "", 1, true).value()->supply_truth().has_value());
  EXPECT_EQ(simulated_body(hyq, "", 1, true).value()->supply_state(), nullptr);
  EXPECT_EQ(simulated_bench(hyq, 1).value()->supply_state(), nullptr);
}

TEST(BodyRobot, RefusesToStandForARobotWithAPumpWithoutOne) {
  const robot::Robot hyq = robot::load_shipped("hyq");
  robot::Robot without = hyq;
  without.supply.reset();
  EXPECT_TRUE(check_supply(hyq, hyq).ok());
  EXPECT_TRUE(check_supply(without, hyq).ok());
  EXPECT_NE(check_supply(hyq, without).error().message.find("give supply.pump in both"), std::string::npos);
}

TEST(BodyRobot, RefusesFaultsOfASupplyForIdealJoints) {
  const body::Scene scene = world::load_scene_text("supply:\n  cut: {start_s: 1, pump_flow_m3_s: 0}", "a.yaml").value();
  const auto ideal = BodyRobot::create(robot::load_shipped("hyq"), scene, 1, true);
  ASSERT_FALSE(ideal.ok());
  EXPECT_EQ(ideal.error().message,
            "a.yaml:2: supply.cut: ideal joints have no supply: simulate the actuators, or leave this out");
}

}  // namespace body_robot_test
}  // namespace farrier::sim_bridge
