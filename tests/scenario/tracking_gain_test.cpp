// Gain of force control from knowing an effect: JointNode on the plant and sensors that have it, on a simulated clock.
// Factors are those measured on these seeds, less a tenth to a third.

#include <gtest/gtest.h>

#include <vector>

#include "robot/wear.hpp"
#include "trials/force_bandwidth.hpp"
#include "trials/tracking_gain.hpp"
#include "robot/joint_effects.hpp"

namespace farrier::trials {
namespace tracking_gain_test {

using plant::effect_id;

const robot::Joint& rig() {
  static const robot::Robot robot = robot::load_robot(std::string(FARRIER_ROBOTS) + "fc1d.yaml").value();
  return robot.joints.front();
}
const robot::Joint& hip() {
  static const robot::Robot robot =
      robot::load_robot(std::string(FARRIER_ROBOTS) + "hyq.yaml", {.without_effects = true}).value();
  return *robot.find("lf_haa");
}

double ratio(const robot::Joint& joint, plant::ActiveEffect effect) {
  const robot::Joint with = robot::with_effects(joint, std::vector{effect}).value();
  const auto gain = tracking_gain(with, joint, with);
  EXPECT_TRUE(gain.ok()) << (gain ? "" : gain.error().message);
  return gain ? gain.value().old_nrmse / gain.value().new_nrmse : 0.0;
}

// A valve of half its gain, of 1.75 times its gain, and what the joint's node gets back by knowing it.
TEST(ForceBandwidth, ComesBackWithTheKnowledgeOfTheValve) {
  static const robot::Robot robot =
      robot::load_robot(std::string(FARRIER_ROBOTS) + "hyq.yaml", {.on_ground = true}).value();
  const robot::Joint& joint = *robot.find("lf_kfe");
  const auto bandwidth = [&](double valve_gain, bool knows) {
    robot::Wear wear = robot::no_wear(joint);
    wear.valve_gain = valve_gain;
    const robot::Joint real = robot::worn(joint, wear);
    const double amplitude = 0.1 * std::min(joint.push_limit, joint.pull_limit);
    return force_bandwidth({.real = real,
                            .designed = joint,
                            .known = knows ? real : joint,
                            .angle_rad = joint.home_angle_rad,
                            .period_s = robot.period_s,
                            .delay_ticks = robot.loop_delay_lockstep},
                           amplitude)
        .value();
  };
  const ForceBandwidth filed = bandwidth(1.0, false);
  ASSERT_TRUE(filed.phase_Hz);
  EXPECT_GT(*filed.phase_Hz, 60.0);
  EXPECT_LT(*filed.phase_Hz, spool_Hz(joint).value());
  const ForceBandwidth half = bandwidth(0.5, false);
  EXPECT_LT(half.phase_Hz.value(), 0.75 * *filed.phase_Hz);
  EXPECT_TRUE(bandwidth(1.75, false).swings);
  for (const double valve_gain : {0.5, 1.75}) {
    const ForceBandwidth adapted = bandwidth(valve_gain, true);
    EXPECT_NEAR(adapted.phase_Hz.value() / *filed.phase_Hz, 1.0, 0.05);
    EXPECT_NEAR(adapted.gain_Hz.value() / filed.gain_Hz.value(), 1.0, 0.05);
  }
}

TEST(TrackingGain, OfANominalJointIsZero) {
  for (const robot::Joint* joint : {&rig(), &hip()}) {
    const auto gain = tracking_gain(*joint, *joint, *joint);
    ASSERT_TRUE(gain.ok()) << gain.error().message;
    EXPECT_EQ(gain.value().old_nrmse, gain.value().new_nrmse);
    EXPECT_LT(gain.value().new_nrmse, 0.12);
  }
}

TEST(TrackingGain, OfAnOverlapGrowsWithIt) {
  EXPECT_GT(ratio(rig(), {effect_id<plant::ValveDeadband>(), {2.7e-4}}), 1.3);
  EXPECT_GT(ratio(rig(), {effect_id<plant::ValveDeadband>(), {5.4e-4}}), 1.7);
  EXPECT_GT(ratio(hip(), {effect_id<plant::ValveDeadband>(), {1.3e-4}}), 2.0);
}

TEST(TrackingGain, OfPortsOfUnlikeSizeAndANarrowPort) {
  EXPECT_GT(ratio(rig(), {effect_id<plant::ValveAsymmetry>(), {0.27}}), 1.8);
  EXPECT_GT(ratio(hip(), {effect_id<plant::FlowSaturation>(), {8.4e-4}}), 1.35);
}

TEST(TrackingGain, OfALoadCellThatReadsWrong) {
  EXPECT_GT(ratio(rig(), {effect_id<plant::ForceSensorGain>(), {0.83}}), 2.2);
  EXPECT_GT(ratio(rig(), {effect_id<plant::ForceSensorOffset>(), {13.0}}), 2.2);
  EXPECT_GT(ratio(hip(), {effect_id<plant::ForceSensorLag>(), {0.0044}}), 2.5);
}

TEST(TrackingGain, OfAVelocityThatIsReadLate) {
  EXPECT_GT(ratio(rig(), {effect_id<plant::VelocityFilterLag>(), {0.0057}}), 1.5);
  EXPECT_GT(ratio(hip(), {effect_id<plant::VelocityFilterLag>(), {0.0115}}), 1.7);
}

TEST(TrackingGain, OfASupplyThatFalls) {
  EXPECT_GT(ratio(rig(), {effect_id<plant::SupplyDroop>(), {1.8e11}}), 1.3);
  EXPECT_GT(ratio(hip(), {effect_id<plant::SupplyDroop>(), {3.35e11}}), 1.35);
}

// The hip's nominal loop does not tolerate a tick of delay: it swings between the valve's limits.
TEST(TrackingGain, OfADelayAndASlowSpoolIsALoopThatStaysStable) {
  for (const double delay_s : {0.0014, 0.003, 0.006}) {
    const plant::ActiveEffect delay{effect_id<plant::InputDelay>(), {delay_s}};
    const robot::Joint with = robot::with_effects(hip(), std::vector{delay}).value();
    const auto gain = tracking_gain(with, hip(), with);
    ASSERT_TRUE(gain.ok());
    EXPECT_GT(gain.value().old_nrmse, 3.0) << delay_s;
    EXPECT_LT(gain.value().new_nrmse, 0.25) << delay_s;
  }
  EXPECT_GT(ratio(rig(), {effect_id<plant::InputDelay>(), {0.0033}}), 1.4);
  EXPECT_GT(ratio(rig(), {effect_id<plant::ValveDynamics>(), {386.0, 0.7}}), 1.4);
}

// Integral action has found a steady null shift before anything is judged.
TEST(TrackingGain, OfANullShiftIsNegligible) {
  EXPECT_NEAR(ratio(rig(), {effect_id<plant::ValveBias>(), {2.7e-4}}), 1.0, 0.01);
}

// Effects that a diagnosis finds never have exactly the true values.
TEST(TrackingGain, ToleratesEffectValuesThatAreAFifthOff) {
  for (const plant::ActiveEffect& effect :
       std::vector<plant::ActiveEffect>{{effect_id<plant::InputDelay>(), {0.006}},
                                        {effect_id<plant::ValveDynamics>(), {190.0, 0.7}},
                                        {effect_id<plant::ValveDeadband>(), {1.3e-4}},
                                        {effect_id<plant::ForceSensorLag>(), {0.01}}}) {
    const robot::Joint world = robot::with_effects(hip(), std::vector{effect}).value();
    for (const double off : {0.83, 1.2}) {
      plant::ActiveEffect found = effect;
      found.values[0] *= off;
      const auto gain = tracking_gain(world, hip(), robot::with_effects(hip(), std::vector{found}).value());
      ASSERT_TRUE(gain.ok());
      EXPECT_LT(gain.value().new_nrmse, 0.8 * gain.value().old_nrmse) << effect.info().name << " times " << off;
    }
  }
}

TEST(TrackingGain, RefusesAJointThatCannotBe) {
  robot::Joint broken = rig();
  broken.actuator.supply_pressure_Pa = -1.0;
  EXPECT_FALSE(tracking_gain(broken, rig(), rig()));
}

}  // namespace tracking_gain_test
}  // namespace farrier::trials
