// The actuators of a robot on a ground and their shared supply.

#include "world/actuators.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/allocation_guard.hpp"
#include "world/body_world.hpp"

namespace farrier::world {
namespace actuators_test {

robot::Robot load(const std::string& name, bool on_ground = true) {
  return robot::load_robot(FARRIER_ROBOTS + name + ".yaml", {.on_ground = on_ground}).value();
}

TEST(Actuators, HaveTheEffectsOfARobotOnAGround) {
  const robot::Robot hyq = load("hyq");
  for (const robot::Joint& joint : hyq.joints) {
    EXPECT_EQ(joint.kind, control::Kind::kFeedbackLinearisation) << joint.name;
    const auto has = [&](const char* name) { return plant::find(joint.effects, plant::find_effect(name)) != nullptr; };
    EXPECT_TRUE(has("valve_dynamics")) << joint.name;
    EXPECT_TRUE(has("valve_deadband")) << joint.name;
    EXPECT_FALSE(has("supply_droop")) << joint.name << ": the supply is shared";
  }
  EXPECT_EQ(hyq.loop_delay_lockstep, hyq.loop_delay_realtime);
  EXPECT_EQ(load("hyq", false).joints[0].kind, control::Kind::kLqr);
  EXPECT_EQ(load("hyq", false).loop_delay_lockstep, 0);
}

/// HyQ with its valves shut, on its feet.
class ShutValves : public testing::Test {
 protected:
  void run(int ticks) {
    const std::vector<double> shut(hyq_.joints.size(), 0.0);
    actuators_.command(shut);
    for (int tick = 0; tick < ticks; ++tick) {
      ASSERT_TRUE(body_.advance(actuators_));
    }
  }

  const robot::Robot hyq_ = load("hyq");
  BodyWorld body_ = BodyWorld::create(hyq_, {}, 1).value();
  Actuators actuators_ = Actuators::create(hyq_).value();
};

TEST_F(ShutValves, CarryTheRobotOnTheirOil) {
  const double before_m = body_.state().position_m.z();
  run(300);
  // Leaks past the lands let it sink by millimetres.
  EXPECT_LT(before_m - body_.state().position_m.z(), 0.02);
  EXPECT_GT(before_m - body_.state().position_m.z(), 0.0);
  double weight_N = 0.0;
  for (int leg = 0; leg < 4; ++leg) {
    weight_N += body_.foot_force_N(leg).z();
  }
  EXPECT_NEAR(weight_N, 84.756 * 9.81, 60.0);
}

TEST_F(ShutValves, KeepTheEnergyOfOilAndBody) {
  run(500);
  const ActuatorEnergies& energies = actuators_.energies();
  // The body has moved under forces that were held over each step.
  EXPECT_LT(std::abs(energies.coupling_J), 0.05 * std::abs(energies.work_J));
  EXPECT_NE(energies.work_J, 0.0);
}

TEST_F(ShutValves, AccountForThePump) {
  run(1000);
  const double pump_J = actuators_.supply()->account().pump_J;
  EXPECT_NEAR(pump_J, 160e5 * 2e-4, 1.0) << "for one second at the relief pressure";
  EXPECT_LT(std::abs(actuators_.audit().residual_J()), 0.01 * pump_J);
}

// Without a pump the null leakage of the valves lowers the pressure: the energy comes from the accumulator.
TEST_F(ShutValves, LoseTheirSupplyAtTheTickOfItsFault) {
  actuators_ = Actuators::create(hyq_, {{.name = "cut", .start_s = 0.1, .pump_flow_m3_s = 0.0}}).value();
  const std::vector<double> shut(hyq_.joints.size(), 0.0);
  const auto run_to = [&](int end) {
    for (auto tick = static_cast<int>(body_.tick()); tick < end; ++tick) {
      actuators_.command(shut, tick * hyq_.period_s);
      ASSERT_TRUE(body_.advance(actuators_));
    }
  };
  run_to(100);
  EXPECT_NEAR(actuators_.supply()->pressure_Pa(), 160e5, 1e3);
  EXPECT_EQ(actuators_.supply()->params().pump_flow_m3_s, hyq_.supply->pump_flow_m3_s);
  const double pump_J = actuators_.supply()->account().pump_J;
  run_to(600);
  EXPECT_EQ(actuators_.supply()->params().pump_flow_m3_s, 0.0);
  EXPECT_EQ(actuators_.supply()->account().pump_J, pump_J);
  EXPECT_LT(actuators_.supply()->pressure_Pa(), 155e5);
  EXPECT_LT(std::abs(actuators_.audit().residual_J()), 0.01 * pump_J);
}

TEST_F(ShutValves, AccountForAnAccumulatorThatIsLost) {
  actuators_ = Actuators::create(hyq_, {{.name = "lost", .start_s = 0.0, .accumulator_volume_m3 = 1e-5}}).value();
  run(1000);
  const plant::SupplyAccount& account = actuators_.supply()->account();
  EXPECT_GT(account.removed_J, 100.0);
  EXPECT_LT(std::abs(actuators_.audit().residual_J()), 0.01 * account.pump_J);
}

TEST(Actuators, RefuseFaultsOfASupplyThatIsNotThere) {
  const body::SupplyChange cut{.name = "cut", .pump_flow_m3_s = 0.0, .origin = "scene.yaml:2"};
  const auto electric = Actuators::create(load("electric_quad"), {cut});
  ASSERT_FALSE(electric.ok());
  EXPECT_TRUE(electric.error().message.starts_with("scene.yaml:2: supply.cut: electric_quad has no pump: give"))
      << electric.error().message;
  robot::Robot hyq = load("hyq");
  hyq.supply->accumulator_volume_m3 = hyq.supply->precharge_Pa = 0.0;
  const body::SupplyChange more{.name = "more", .accumulator_volume_m3 = 1e-4, .origin = "scene.yaml:3"};
  const auto without = Actuators::create(hyq, {more});
  ASSERT_FALSE(without.ok());
  EXPECT_TRUE(without.error().message.starts_with("scene.yaml:3: supply.more.accumulator_volume_m3: "))
      << without.error().message;
  EXPECT_TRUE(Actuators::create(hyq, {cut}).ok());
}

TEST_F(ShutValves, AllocateNothingAndGiveTheSameBits) {
  BodyWorld other_body = BodyWorld::create(hyq_, {}, 1).value();
  Actuators other = Actuators::create(hyq_).value();
  run(20);
  {
    const test::AllocationGuard guard;
    for (int tick = 0; tick < 20; ++tick) {
      other_body.advance(other);
    }
    EXPECT_EQ(guard.allocations(), 0u);
  }
  EXPECT_EQ(body_.state().position_m, other_body.state().position_m);
  EXPECT_EQ(actuators_.torques_Nm(), other.torques_Nm());
  EXPECT_EQ(actuators_.supply()->pressure_Pa(), other.supply()->pressure_Pa());
}

TEST(Actuators, OfAnElectricRobotHaveNoSupply) {
  const robot::Robot robot = load("electric_quad");
  Actuators actuators = Actuators::create(robot).value();
  EXPECT_EQ(actuators.supply(), nullptr);
  EXPECT_EQ(actuators.audit().pump_J, 0.0);
  BodyWorld body = BodyWorld::create(robot, {}, 1).value();
  const std::vector<double> currents(robot.joints.size(), 1.0);
  actuators.command(currents);
  for (int tick = 0; tick < 20; ++tick) {
    ASSERT_TRUE(body.advance(actuators));
  }
  EXPECT_GT(actuators.energies().electric_J, 0.0);
}

TEST(ActuatorChanges, GrowEvenlyFromTheirStart) {
  const robot::Robot hyq = load("hyq");
  Actuators actuators =
      Actuators::create(hyq, {}, {{.name = "drift", .start_s = 0.1, .duration_s = 0.2, .valve_gain = 0.5}}).value();
  const std::vector<double> shut(hyq.joints.size(), 0.0);
  const auto gain_at = [&](double time_s) {
    actuators.command(shut, time_s);
    return actuators.wear(0).valve_gain;
  };
  EXPECT_EQ(gain_at(0.0), 1.0);
  EXPECT_EQ(gain_at(0.09), 1.0);
  EXPECT_NEAR(gain_at(0.2), 0.75, 1e-12);
  EXPECT_NEAR(gain_at(0.3), 0.5, 1e-12);
  EXPECT_NEAR(gain_at(5.0), 0.5, 1e-12);
  EXPECT_NEAR(actuators.joint(0).hydraulic()->actuator().valve_gain, 0.5 * hyq.joints[0].actuator.valve_gain, 1e-18);
}

TEST(ActuatorChanges, OfOneJointLeaveTheOthers) {
  const robot::Robot hyq = load("hyq");
  Actuators actuators =
      Actuators::create(hyq, {}, {{.name = "seal", .joint = "lf_kfe", .leakage_m3_s_Pa = 5e-13}}).value();
  const std::vector<double> shut(hyq.joints.size(), 0.0);
  actuators.command(shut, 0.0);
  for (const robot::Joint& joint : hyq.joints) {
    EXPECT_EQ(actuators.wear(joint.number).leakage, joint.name == "lf_kfe" ? 5e-13 : 0.0) << joint.name;
  }
}

TEST(ActuatorChanges, OfAJointThatIsNotThereAreRefused) {
  const auto refused = Actuators::create(
      load("hyq"), {}, {{.name = "coil", .joint = "tail", .valve_gain = 0.5, .origin = "scene.yaml:2"}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message,
            "scene.yaml:2: actuators.coil.joint: hyq has no joint tail: give one of its joints, or leave the key out "
            "for all");
}

}  // namespace actuators_test
}  // namespace farrier::world
