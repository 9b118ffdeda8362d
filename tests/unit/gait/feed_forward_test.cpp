#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gait/leg_kinematics.hpp"
#include "gait/reference.hpp"
#include "tests/unit/gait/plan.hpp"

namespace farrier::gait {
namespace feed_forward_test {

constexpr int kLegs = 4;
constexpr int kJoints = 3;
constexpr Tick kRun = 6000;

RobotPlan weightless(RobotPlan plan) {
  plan.body_weight_N = 0.0;
  return plan;
}

RobotPlan massless(RobotPlan plan) {
  for (LegPlan& leg : plan.legs) {
    for (JointPlan& joint : leg.joints) {
      joint.swing_load.mass = joint.stance_load.mass = 0.0;
    }
  }
  return plan;
}

// The force the leg of a massless plan pushes the ground with: J^T f = tau.
Eigen::Vector3d push(const RobotPlan& plan, const Reference& reference, int leg, Tick tick) {
  Eigen::Vector3d q, torque;
  for (int joint = 0; joint < kJoints; ++joint) {
    q[joint] = reference.at(leg, joint, tick).position_rad;
    torque[joint] = reference.at(leg, joint, tick).torque_ff_Nm;
  }
  return jacobian(plan.legs[leg].geometry, q).transpose().inverse() * torque;
}

TEST(LoadShare, IsZeroAtBothEndsAndInSwingAndWholeBetweenTheRamps) {
  EXPECT_EQ(load_share(-1.0, 0.2), 0.0);
  EXPECT_EQ(load_share(0.0, 0.2), 0.0);
  EXPECT_EQ(load_share(1.0, 0.2), 0.0);
  EXPECT_EQ(load_share(0.2, 0.2), 1.0);
  EXPECT_EQ(load_share(0.5, 0.5), 1.0);
  EXPECT_EQ(load_share(0.1, 0.2), 0.5);
  EXPECT_EQ(load_share(0.0, 0.0), 1.0);
}

TEST(LoadShare, RampsOutAsItRampedIn) {
  constexpr double kRounding = 1e-12;
  for (double progress = 0.0; progress <= 1.0; progress += 0.01) {
    EXPECT_NEAR(load_share(progress, 0.3), load_share(1.0 - progress, 0.3), kRounding);
  }
}

TEST(LoadShare, OutgoingAndIncomingRampsAddToOne) {
  constexpr double kRounding = 1e-12;
  for (double x = 0.0; x <= 0.25; x += 0.01) {
    EXPECT_NEAR(load_share(x, 0.25) + load_share(0.75 + x, 0.25), 1.0, kRounding);
  }
}

TEST(FeedForward, LegsCarryTheRobotsWeightTogetherFromTheEndOfTheLeadInOn) {
  const RobotPlan plan = massless(hyq_plan());
  const Reference reference(plan);
  // Phases in whole ticks overlap by 107 of the 107.08 ticks the ramps take; ramps rise by at most 2.19 of their length
  constexpr double kTolerance_N = kBodyWeight_N * 2.19 * 0.08 / 107.0;
  for (Tick tick = Schedule(plan, 0).lead_in_ticks(); tick < kRun; ++tick) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int leg = 0; leg < kLegs; ++leg) {
      sum += push(plan, reference, leg, tick);
    }
    ASSERT_NEAR(sum.z(), -kBodyWeight_N, kTolerance_N) << tick;
    ASSERT_NEAR(sum.head<2>().norm(), 0.0, 1e-9 * kBodyWeight_N) << "ground forces are vertical";
  }
}

TEST(FeedForward, TwoLegsCarryHalfTheWeightEachInMidStanceOfATrot) {
  const RobotPlan plan = massless(hyq_plan());
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  int seen = 0;
  for (Tick tick = 2000; tick < kRun; ++tick) {
    if (schedule.ticks_since_touchdown(0, tick) == schedule.stance_ticks() / 2) {
      EXPECT_NEAR(push(plan, reference, 0, tick).z(), -kBodyWeight_N / 2, 1e-9 * kBodyWeight_N);
      EXPECT_NEAR(push(plan, reference, 1, tick).z(), 0.0, 1e-9 * kBodyWeight_N);
      ++seen;
    }
  }
  EXPECT_GE(seen, 5);
}

TEST(FeedForward, StandingLegsCarryAQuarterEachOnceTheLeadInBroughtItIn) {
  const RobotPlan plan = massless(hyq_standing());
  const Reference reference(plan);
  const Tick lead_in = Schedule(plan, 0).lead_in_ticks();
  for (int leg = 0; leg < kLegs; ++leg) {
    EXPECT_NEAR(push(plan, reference, leg, lead_in).z(), -kBodyWeight_N / 4, 1e-9 * kBodyWeight_N);
    for (Tick tick = 0; tick < lead_in; ++tick) {
      const double progress = 0.5 * static_cast<double>(tick) / static_cast<double>(lead_in);
      const double share = load_share(progress, plan.gait.load_transfer_fraction);
      ASSERT_NEAR(push(plan, reference, leg, tick).z(), -share * kBodyWeight_N / 4, 1e-9 * kBodyWeight_N);
    }
  }
}

// With a duty of one half the diagonals do not overlap: the robot is let down between them, and no leg makes up for it.
TEST(FeedForward, NoLegOfATrotCarriesMoreThanItsShareOfHalfTheWeight) {
  RobotPlan plan = massless(hyq_plan());
  plan.gait.duty = 0.5;
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  for (Tick tick = 2000; tick < kRun; ++tick) {
    for (int leg = 0; leg < kLegs; ++leg) {
      const double share = load_share(schedule.stance_progress(leg, tick), plan.gait.load_transfer_fraction);
      ASSERT_NEAR(push(plan, reference, leg, tick).z(), -share * kBodyWeight_N / 2, 1e-9 * kBodyWeight_N) << tick;
    }
  }
}

TEST(FeedForward, IsZeroAtLiftOffAndTouchdown) {
  const RobotPlan plan = hyq_plan();
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  for (int leg = 0; leg < kLegs; ++leg) {
    for (Tick tick = 1; tick < kRun; ++tick) {
      if (schedule.phase(leg, tick) != schedule.phase(leg, tick - 1)) {
        for (int joint = 0; joint < kJoints; ++joint) {
          ASSERT_EQ(reference.at(leg, joint, tick).torque_ff_Nm, 0.0) << leg << joint << " at " << tick;
        }
      }
    }
  }
}

double largest_change(const RobotPlan& plan, double end_s) {
  const Reference reference(plan);
  double largest = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int joint = 0; joint < kJoints; ++joint) {
      double before = 0.0;
      for (Tick tick = 0; tick < static_cast<Tick>(end_s / plan.period_s); ++tick) {
        const double now = reference.at(leg, joint, tick).torque_ff_Nm;
        largest = std::max(largest, std::abs(now - before));
        before = now;
      }
    }
  }
  return largest;
}

// A step would stay when time is cut finer; a slope shrinks with the tick.
TEST(FeedForward, HasNoStep) {
  const double coarse = largest_change(hyq_plan(1e-3), 3.0);
  const double fine = largest_change(hyq_plan(1e-4), 3.0);
  EXPECT_NEAR(fine / coarse, 0.1, 0.01);
}

// Second route: the torque's power is the rate of the load's kinetic energy, m x' x'' = d/dt (m x'^2 / 2), wherever
// the whole mass of the phase is fed forward.
TEST(FeedForward, InertiaTorqueDoesTheWorkThatMovesTheLoad) {
  constexpr double kPeriod_s = 1e-4;
  const RobotPlan plan = weightless(hyq_plan(kPeriod_s));
  const Reference reference(plan);
  const Schedule schedule(plan, 0);
  const auto energy = [&](int leg, int joint, Tick tick, double mass) {
    const JointReference now = reference.at(leg, joint, tick);
    const double velocity = plan.legs[leg].joints[joint].linkage.lever(now.position_rad) * now.velocity_rad_s;
    return 0.5 * mass * velocity * velocity;
  };
  int checked = 0;
  for (int leg = 0; leg < kLegs; ++leg) {
    for (int joint = 0; joint < kJoints; ++joint) {
      const JointPlan& of = plan.legs[leg].joints[joint];
      for (Tick tick = 20000; tick < 28000; tick += 11) {
        const double stance = schedule.stance_progress(leg, tick), swing = schedule.swing_progress(leg, tick);
        const bool mid_stance = stance > 0.25 && stance < 0.75, mid_swing = swing > 0.15 && swing < 0.85;
        if (!mid_stance && !mid_swing) {
          continue;
        }
        const double mass = mid_stance ? of.stance_load.mass : of.swing_load.mass;
        const JointReference now = reference.at(leg, joint, tick);
        const double rate =
            (energy(leg, joint, tick + 1, mass) - energy(leg, joint, tick - 1, mass)) / (2.0 * kPeriod_s);
        constexpr double kTruncation_W = 1e-2;  // h^2/6 of d3E/dt3: 0.5 kg m^2 x (5 rad/s)^2 / 2 x (40 / 0.25 s)^3
        ASSERT_NEAR(now.torque_ff_Nm * now.velocity_rad_s, rate, kTruncation_W + 1e-3 * std::abs(rate));
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 1000);
}

RobotPlan rig() {
  JointPlan piston{.joint = 0,
                   .linkage = plant::Linkage::direct(0.04, 0.0),
                   .swing_load = {},
                   .stance_load = {},
                   .home_angle_rad = 0.7,
                   .stiffness_Nm_rad = 0.0,
                   .damping_Nms_rad = 0.0};
  RobotPlan plan{.period_s = 0.001, .body_weight_N = 0.0, .gait = {}, .legs = {{"rig", {}, {piston}, 0.0}}};
  plan.gait.pattern = Pattern::kStand;
  plan.gait.reference = ReferenceKind::kMultisine;
  plan.gait.multisine_frequencies_Hz = {2.0, 5.0, 10.0};
  plan.gait.multisine_amplitude_N = 160.0;
  return plan;
}

TEST(Multisine, HoldsEqualSharesOfTheAmplitudeAtItsFrequenciesAndNothingElse) {
  const RobotPlan plan = rig();
  const Reference reference(plan);
  const auto amplitude = [&](double frequency_Hz) {  // projection over one second, a whole number of periods
    double sum = 0.0;
    for (Tick tick = 1000; tick < 2000; ++tick) {
      const double phase = 2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(tick) * plan.period_s;
      sum += reference.at(0, 0, tick).torque_ff_Nm / 0.04 * std::sin(phase);
    }
    return 2.0 * sum / 1000.0;
  };
  constexpr double kRounding_N = 1e-9;
  for (const double frequency_Hz : {2.0, 5.0, 10.0}) {
    EXPECT_NEAR(amplitude(frequency_Hz), 160.0 / 3.0, kRounding_N);
  }
  EXPECT_NEAR(amplitude(7.0), 0.0, kRounding_N);
}

TEST(Multisine, HoldsHomeAndComesInSmoothly) {
  const Reference reference(rig());
  EXPECT_EQ(reference.at(0, 0, 0).torque_ff_Nm, 0.0);
  for (Tick tick = 0; tick < 3000; ++tick) {
    const JointReference now = reference.at(0, 0, tick);
    ASSERT_EQ(now.position_rad, 0.7);
    ASSERT_EQ(now.velocity_rad_s, 0.0);
    ASSERT_LE(std::abs(now.torque_ff_Nm), 0.04 * 160.0);
  }
  EXPECT_LT(std::abs(reference.at(0, 0, 50).torque_ff_Nm), 0.01 * 0.04 * 160.0);
}

}  // namespace feed_forward_test
}  // namespace farrier::gait
