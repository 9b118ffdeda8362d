#include "gait/reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gait/leg_kinematics.hpp"
#include "tests/unit/gait/plan.hpp"

namespace farrier::gait {
namespace reference_test {

constexpr int kLegs = 4;
constexpr int kJoints = 3;
constexpr Tick kSettled = 2000;  // lead-in and the growing stride are over
constexpr Tick kRun = 6000;

Eigen::Vector3d angles(const Reference& reference, int leg, Tick tick) {
  return {reference.at(leg, 0, tick).position_rad, reference.at(leg, 1, tick).position_rad,
          reference.at(leg, 2, tick).position_rad};
}

TEST(Reference, StartsAtHomeAtRestWithoutTorque) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  constexpr double kRounding_rad = 1e-12;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int joint = 0; joint < kJoints; ++joint) {
      const JointReference start = reference.at(leg, joint, 0);
      EXPECT_NEAR(start.position_rad, plan.legs[leg].joints[joint].home_angle_rad, kRounding_rad);
      EXPECT_EQ(start.velocity_rad_s, 0.0);
      EXPECT_EQ(start.acceleration_rad_s2, 0.0);
      EXPECT_EQ(start.torque_ff_Nm, 0.0);
    }
  }
}

// At 0.1 ms a tick, so that the truncation of the central differences is far below what a mistake would show.
TEST(Reference, VelocityIsTheDerivativeOfPositionAndAccelerationOfVelocity) {
  constexpr double kPeriod_s = 1e-4;
  constexpr double kJerk_rad_s3 = 2e4;   // bounds of q''' and q'''' of this trot: 212 rad/s^2 within a swing of 0.25 s,
  constexpr double kSnap_rad_s4 = 2e6;   // whose polynomials multiply rates by at most 40 / 0.25 s per derivative
  const Reference reference(hyq_plan(kPeriod_s));
  const auto end = static_cast<Tick>(3.0 / kPeriod_s);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int joint = 0; joint < kJoints; ++joint) {
      JointReference before = reference.at(leg, joint, 0), now = reference.at(leg, joint, 1);
      for (Tick tick = 1; tick < end; ++tick) {
        const JointReference after = reference.at(leg, joint, tick + 1);
        const double velocity = (after.position_rad - before.position_rad) / (2.0 * kPeriod_s);
        const double acceleration = (after.velocity_rad_s - before.velocity_rad_s) / (2.0 * kPeriod_s);
        ASSERT_NEAR(now.velocity_rad_s, velocity, kPeriod_s * kPeriod_s * kJerk_rad_s3 / 6.0) << leg << joint << tick;
        ASSERT_NEAR(now.acceleration_rad_s2, acceleration, kPeriod_s * kPeriod_s * kSnap_rad_s4 / 6.0)
            << leg << joint << tick;
        ASSERT_NEAR(after.acceleration_rad_s2, now.acceleration_rad_s2, kPeriod_s * kJerk_rad_s3)
            << "acceleration jumps at " << tick;
        before = now;
        now = after;
      }
    }
  }
}

TEST(Reference, FootGoesBackwardAtConstantSpeedAndHeightInStance) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  const double stance_s = static_cast<double>(schedule.stance_ticks()) * plan.period_s;
  constexpr double kRounding = 1e-10;
  for (int leg = 0; leg < kLegs; ++leg) {
    const LegGeometry& geometry = plan.legs[leg].geometry;
    const double width = fk(geometry, angles(reference, leg, 0)).y();
    for (Tick tick = kSettled; tick < kRun; ++tick) {
      const Eigen::Vector3d q = angles(reference, leg, tick);
      const Eigen::Vector3d rates{reference.at(leg, 0, tick).velocity_rad_s, reference.at(leg, 1, tick).velocity_rad_s,
                                  reference.at(leg, 2, tick).velocity_rad_s};
      const Eigen::Vector3d foot = fk(geometry, q);
      const Eigen::Vector3d velocity = jacobian(geometry, q) * rates;
      ASSERT_NEAR(foot.y(), width, kRounding);
      if (schedule.phase(leg, tick) == Phase::kStance) {
        ASSERT_NEAR(foot.z(), -plan.gait.hip_height_m, kRounding);
        ASSERT_NEAR(velocity.x(), -plan.gait.step_length_m / stance_s, kRounding);
        ASSERT_NEAR(velocity.z(), 0.0, kRounding);
      }
    }
  }
}

TEST(Reference, FootRisesToTheStepHeightInMidSwing) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const double mid_swing_slack_m = 1e-4;  // the swing's middle may lie between two ticks
  for (int leg = 0; leg < kLegs; ++leg) {
    double highest = -1.0;
    for (Tick tick = kSettled; tick < kRun; ++tick) {
      highest = std::max(highest, fk(plan.legs[leg].geometry, angles(reference, leg, tick)).z());
    }
    EXPECT_NEAR(highest, plan.gait.step_height_m - plan.gait.hip_height_m, mid_swing_slack_m);
  }
}

TEST(Reference, RepeatsEveryStrideBitForBit) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const Tick stride = Schedule(plan, 0).stride_ticks();
  for (Tick tick = kSettled; tick < kRun; tick += 7) {
    const JointReference now = reference.at(2, 2, tick), later = reference.at(2, 2, tick + 5 * stride);
    ASSERT_EQ(now.position_rad, later.position_rad);
    ASSERT_EQ(now.velocity_rad_s, later.velocity_rad_s);
    ASSERT_EQ(now.acceleration_rad_s2, later.acceleration_rad_s2);
    ASSERT_EQ(now.torque_ff_Nm, later.torque_ff_Nm);
  }
}

TEST(Reference, StrideGrowsFromNothingAfterTheLeadIn) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  const double neutral = fk(plan.legs[1].geometry, angles(reference, 1, 0)).x();
  const auto way = [&](Tick begin, Tick end) {
    double most = 0.0;
    for (Tick tick = begin; tick < end; ++tick) {
      most = std::max(most, std::abs(fk(plan.legs[1].geometry, angles(reference, 1, tick)).x() - neutral));
    }
    return most;
  };
  const Tick lead_in = schedule.lead_in_ticks(), stride = schedule.stride_ticks();
  EXPECT_LT(way(0, lead_in + 1), 1e-12);
  EXPECT_LT(way(lead_in, lead_in + stride / 4), 0.1 * plan.gait.step_length_m);
  EXPECT_GT(way(lead_in + stride, lead_in + 2 * stride), 0.49 * plan.gait.step_length_m);
}

struct Range {
  double low = 1e9, high = -1e9;
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }
};

// IIT's trot: 1.4 Hz, duty 0.65, step 0.3 of the hip height. Limits of hyq-description, right-hind sign.
TEST(Reference, HyQsTrotBendsTheKneesAndStaysWithinJointsCylindersAndSpeed) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr std::array<Range, kJoints> kLimits{
      {{-70 * kDegree, 25 * kDegree}, {-70 * kDegree, 50 * kDegree}, {20 * kDegree, 140 * kDegree}}};
  constexpr double kAngleMargin_rad = 0.1, kPistonMargin_m = 0.005, kSpeed_rad_s = 12.0, kKneeTravel_rad = 0.3;
  const RobotPlan plan = hyq_plan();
  EXPECT_NEAR(plan.gait.step_length_m, 0.3 * plan.gait.hip_height_m, 0.0005);
  const Reference reference(plan);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int joint = 0; joint < kJoints; ++joint) {
      const double sign = joint > 0 && plan.legs[leg].geometry.front ? -1.0 : 1.0;
      Range angle, piston, speed;
      for (Tick tick = 0; tick < kRun; ++tick) {
        const JointReference now = reference.at(leg, joint, tick);
        angle.include(sign * now.position_rad);
        piston.include(plan.legs[leg].joints[joint].linkage.position(now.position_rad));
        speed.include(now.velocity_rad_s);
      }
      EXPECT_GT(angle.low, kLimits[joint].low + kAngleMargin_rad) << leg << joint;
      EXPECT_LT(angle.high, kLimits[joint].high - kAngleMargin_rad) << leg << joint;
      EXPECT_LT(std::max(-speed.low, speed.high), kSpeed_rad_s) << leg << joint;
      if (joint > 0) {  // the cylinders
        EXPECT_GT(piston.low, kPistonMargin_m) << leg << joint;
        EXPECT_LT(piston.high, kStroke_m - kPistonMargin_m) << leg << joint;
      }
      if (joint == 2) {
        EXPECT_GT(angle.high - angle.low, kKneeTravel_rad) << leg;
      }
    }
  }
}

// A touchdown may come 10 ms early or late; the load that jumps then should not be accelerating much.
TEST(Reference, KneeHardlyAcceleratesAroundTouchdown) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  constexpr Tick kJitter = 10;
  constexpr double kShare = 0.15;
  for (int leg = 0; leg < kLegs; ++leg) {
    double near = 0.0, anywhere = 0.0;
    for (Tick tick = kSettled; tick < kRun; ++tick) {
      const double size = std::abs(reference.at(leg, 2, tick).acceleration_rad_s2);
      const Tick since = schedule.ticks_since_touchdown(leg, tick);
      anywhere = std::max(anywhere, size);
      near = since <= kJitter || since >= schedule.stride_ticks() - kJitter ? std::max(near, size) : near;
    }
    EXPECT_LT(near, kShare * anywhere) << leg;
  }
}

TEST(Reference, AStandingRobotHoldsStillAtTheHipHeight) {
  const RobotPlan plan = hyq_standing();
  const Reference reference(plan);
  const Tick lead_in = Schedule(plan, 0).lead_in_ticks();
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_NEAR(fk(plan.legs[leg].geometry, angles(reference, leg, lead_in)).z(), -plan.gait.hip_height_m, 1e-12);
    for (Tick tick = lead_in; tick < kRun; tick += 13) {
      ASSERT_EQ(angles(reference, leg, tick), angles(reference, leg, lead_in));
      ASSERT_EQ(reference.at(leg, 2, tick).velocity_rad_s, 0.0);
      ASSERT_EQ(reference.at(leg, 2, tick).acceleration_rad_s2, 0.0);
    }
  }
}

}  // namespace reference_test
}  // namespace farrier::gait
