// The estimator of a valve's gain, overlap and leakage, on a piston that a mechanism moves.

#include "estimation/valve/valve_flow_estimator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/make_estimator.hpp"
#include "robot/wear.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/estimation/moved_joint.hpp"

namespace farrier::estimation {
namespace valve_flow_test {

TEST(ValveFlow, FindsTheGainOfAWornValveWithinThreePercent) {
  for (const double gain : {0.7, 1.0, 1.3}) {
    robot::Wear wear = no_wear();
    wear.valve_gain = gain;
    MovedJoint moved(wear);
    moved.run(3.0);
    const ModelEstimate estimate = moved.estimate();
    EXPECT_NEAR(moved.gain(), gain, 0.03 * gain) << gain;
    EXPECT_NEAR(moved.overlap_percent(), 0.6, 0.3) << gain;
    EXPECT_GT(estimate.validity, 0.9);
    EXPECT_TRUE(estimate.has_physics);
  }
}

TEST(ValveFlow, FindsAWiderOverlap) {
  robot::Wear wear = no_wear();
  wear.overlap_A = 3e-4;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.overlap_percent(), 3.0, 0.4);
  EXPECT_NEAR(moved.gain(), 1.0, 0.06);
}

TEST(ValveFlow, FindsALeakagePastThePiston) {
  robot::Wear wear = no_wear();
  wear.leakage = 5e-13;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.estimate().physics.leakage, 5e-13, 1.5e-13);
}

TEST(ValveFlow, FindsOilThatIsSofterThanItsFileSays) {
  for (const double bulk_modulus : {0.4, 1.0}) {
    robot::Wear wear = no_wear();
    wear.bulk_modulus = bulk_modulus;
    MovedJoint moved(wear);
    moved.press_with(8.0);
    moved.run(10.0);
    const ModelEstimate estimate = moved.estimate();
    const double nominal_Pa = moved.joint().actuator.bulk_modulus_Pa;
    EXPECT_NEAR(nominal_Pa / estimate.physics.bulk_modulus, 1.0 / bulk_modulus, 0.3 / bulk_modulus) << bulk_modulus;
    EXPECT_GT(estimate.physics_error.bulk_modulus, 0.0);
    EXPECT_NEAR(moved.gain(), 1.0, 0.04) << bulk_modulus;
  }
}

TEST(ValveFlow, FollowsAValveThatLosesHalfItsGainWithinAFifthOfASecond) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.03);
  robot::Wear lost = no_wear();
  lost.valve_gain = 0.5;
  moved.wear(lost);
  moved.run(0.2);
  EXPECT_NEAR(moved.gain(), 0.5, 0.05);
}

TEST(ValveFlow, CountsAValveThatGrowsAsStrongerUntilItIsEstimatedAgain) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  robot::Wear grown = no_wear();
  grown.valve_gain = 1.75;
  moved.wear(grown);
  moved.run(0.03);
  const ModelEstimate counted = moved.estimate();
  EXPECT_NE(counted.flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_EQ(counted.validity, 0.0);
  EXPECT_GT(moved.gain(), 1.4);
  moved.run(1.0);
  EXPECT_EQ(moved.estimate().flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_NEAR(moved.gain(), 1.75, 0.09);
}

TEST(ValveFlow, StaysAsSureOfTheOilWhenTheValveChanges) {
  MovedJoint moved(no_wear());
  moved.run(3.0);
  const ModelEstimate before = moved.estimate();
  robot::Wear grown = no_wear();
  grown.valve_gain = 1.75;
  moved.wear(grown);
  moved.run(0.03);
  const ModelEstimate after = moved.estimate();
  ASSERT_NE(after.flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_GT(after.physics_error.valve_gain, 3.0 * before.physics_error.valve_gain);
  EXPECT_LT(after.physics_error.bulk_modulus, 2.1 * before.physics_error.bulk_modulus);
}

void oscillate(MovedJoint& moved) {
  for (Tick tick = 0; tick < 50; ++tick) {
    const double error_N = 900.0 * std::sin(2.0 * kPi * 0.115 * static_cast<double>(tick));
    moved.estimator().take({.tick = moved.tick() + tick,
                            .state = {0.04, 0.0, -error_N},
                            .current_A = 1e-5,
                            .phase = 0,
                            .force_error = error_N});
  }
}

TEST(ValveFlow, CountsTheValveOfAnOscillatingLoopAsStronger) {
  MovedJoint moved(no_wear());
  moved.run(2.0);
  oscillate(moved);
  EXPECT_NE(moved.estimate().flags & bit(EstimateFlag::kCountsAsStronger), 0u);
  EXPECT_NEAR(moved.gain(), 1.5, 0.05);
}

TEST(ValveFlow, CountsTheOilAsStifferIfTheLoopOscillatesAgainWithTheSameValve) {
  MovedJoint moved(no_wear());
  const double nominal_Pa = moved.joint().actuator.bulk_modulus_Pa;
  moved.run(2.0);
  oscillate(moved);
  EXPECT_EQ(moved.estimate().physics.bulk_modulus, nominal_Pa) << "the valve is suspected first";
  moved.run(1.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.1);
  oscillate(moved);
  EXPECT_DOUBLE_EQ(moved.estimate().physics.bulk_modulus, 1.5 * nominal_Pa);
  moved.run(1.0);
  for (int again = 0; again < 5; ++again) {
    oscillate(moved);
    moved.run(1.0);
  }
  EXPECT_DOUBLE_EQ(moved.estimate().physics.bulk_modulus, 2.0 * nominal_Pa) << "the largest that is given on";
}

TEST(ValveFlow, DoesNotTakeAWeakSupplyForAWeakValveOnceItIsTold) {
  for (const bool told : {true, false}) {
    MovedJoint moved(no_wear());
    moved.weaken_supply(112e5, told);
    moved.run(3.0);
    if (told) {
      EXPECT_NEAR(moved.gain(), 1.0, 0.04);
    } else {
      EXPECT_LT(moved.gain(), 0.9);
    }
  }
}

TEST(ValveFlow, FindsTheGainInThickOil) {
  robot::Wear wear = no_wear();
  wear.viscosity = 4.0;
  MovedJoint moved(wear);
  moved.run(4.0);
  EXPECT_NEAR(moved.gain(), 1.0, 0.05);
}

TEST(ValveFlow, LearnsNothingFromAShutValve) {
  MovedJoint moved(no_wear());
  for (Tick tick = 0; tick < 500; ++tick) {
    moved.estimator().take({.tick = tick, .state = {0.04, 0.0, 300.0}, .current_A = 2e-5, .phase = 0});
  }
  const ModelEstimate estimate = moved.estimate();
  EXPECT_EQ(estimate.samples, 0u);
  EXPECT_EQ(estimate.validity, 0.0);
  EXPECT_NE(estimate.flags & bit(EstimateFlag::kNotYetSet), 0u);
  EXPECT_NE(estimate.flags & bit(EstimateFlag::kNotExciting), 0u);
  EXPECT_EQ(moved.gain(), 1.0) << "the file's until something is learnt";
}

TEST(ValveFlow, KeepsTheLoadOfTheFile) {
  robot::Wear wear = no_wear();
  wear.valve_gain = 0.7;
  MovedJoint moved(wear);
  moved.run(2.0);
  const ModelEstimate estimate = moved.estimate();
  const bool swings = estimate.phase == static_cast<int>(Phase::kSwing);
  EXPECT_EQ(estimate.physics.load_mass, (swings ? moved.joint().swing_load : moved.joint().stance_load).mass);
  EXPECT_EQ(estimate.physics_error.load_mass, 0.0);
}

TEST(ValveFlow, StaysFiniteThroughGapsAndSamplesThatAreNot) {
  MovedJoint moved(no_wear());
  moved.run(1.0);
  const double before = moved.gain();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  moved.estimator().take({.tick = moved.tick(), .state = {nan, 0.0, 0.0}, .current_A = 0.0, .phase = 0});
  EXPECT_NE(moved.estimate().flags & bit(EstimateFlag::kSampleRefused), 0u);
  moved.estimator().take({.tick = moved.tick() + 500, .state = {0.04, 5.0, -3000.0}, .current_A = 0.01, .phase = 1});
  EXPECT_EQ(moved.gain(), before);
}

TEST(ValveFlow, AllocatesNothing) {
  MovedJoint moved(no_wear());
  moved.run(0.5);
  const test::AllocationGuard guard;
  moved.estimator().take({.tick = moved.tick(), .state = {0.04, 0.1, 100.0}, .current_A = 0.001, .phase = 0});
  const ModelEstimate estimate = moved.estimate();
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(estimate.a.allFinite());
}

TEST(ValveFlow, RefusesSettingsOutOfRange) {
  robot::Joint joint = hfe();
  joint.estimator.valve_flow = ValveFlowParams{.memory_s = 0.0};
  const auto refused = robot::make_estimator(joint, kPeriod_s, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "lf_hfe: valve_flow: memory_s must be above 0, is 0.000000");
}

}  // namespace valve_flow_test
}  // namespace farrier::estimation
