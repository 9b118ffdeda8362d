#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "test_joints.hpp"

namespace farrier::plant {
namespace create_test {

std::string refusal(const ActuatorParams& actuator, const LoadParams& load, const State& initial) {
  const auto joint = HydraulicJoint::create(actuator, load, initial);
  return joint.ok() ? "" : joint.error().message;
}
bool names(const std::string& message, const char* word) { return message.find(word) != std::string::npos; }

const State kMiddle{0.04, 0.0, 50e5, 80e5};

TEST(CreateJoint, AcceptsTheJointsOfTheRobotAndTheRig) {
  EXPECT_EQ(refusal(test::hyq_cylinder(), test::swing_load(), kMiddle), "");
  EXPECT_EQ(refusal(test::rig_cylinder(), test::stance_load(), kMiddle), "");
  EXPECT_EQ(refusal(test::hyq_rotary_motor(), {0.3, 0.1, 0.0, 0.0}, kMiddle), "");
}

TEST(CreateJoint, NamesEveryRefusedValueAtOnce) {
  ActuatorParams actuator = test::hyq_cylinder();
  actuator.area_b = 0.0;
  actuator.bulk_modulus_Pa = std::numeric_limits<double>::quiet_NaN();
  const std::string message =
      refusal(actuator, {-1.0, 0.0, 0.0, 0.0}, {0.2, 0.0, 50e5, -1.0});
  for (const char* word : {"area_b", "bulk_modulus_Pa", "mass", "position", "pressure_b_Pa"}) {
    EXPECT_TRUE(names(message, word)) << word << " missing from: " << message;
  }
  EXPECT_FALSE(names(message, "area_a"));
}

TEST(CreateJoint, RefusesStopsThatCouldNotHoldFullSupply) {
  ActuatorParams actuator = test::hyq_cylinder();
  actuator.stop_stiffness = 1e5;
  EXPECT_TRUE(names(refusal(actuator, test::swing_load(), kMiddle), "stop_stiffness"));
}

TEST(CreateJoint, RefusesModelsTooFastForItsSubsteps) {
  ActuatorParams actuator = test::hyq_cylinder();
  actuator.stop_stiffness = 1e12;
  EXPECT_TRUE(names(refusal(actuator, test::swing_load(), kMiddle), "fastest rate"));
}

TEST(CreateJoint, RefusesToMoveNoMass) {
  ActuatorParams actuator = test::hyq_cylinder();
  actuator.piston_mass = 0.0;
  EXPECT_TRUE(names(refusal(actuator, {0.0, 1.0, 0.0, 0.0}, kMiddle), "mass"));
}

TEST(SetLoad, KeepsTheOldLoadWhenTheNewOneIsRefused) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  EXPECT_FALSE(joint.set_load({-5.0, 0.0, 0.0, 0.0}));
  EXPECT_FALSE(joint.set_load({1.0, std::numeric_limits<double>::infinity(), 0.0, 0.0}));
  EXPECT_EQ(joint.load().mass, test::swing_load().mass);
}

}  // namespace create_test
}  // namespace farrier::plant
