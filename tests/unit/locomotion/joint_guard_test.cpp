#include "locomotion/guards/joint_guard.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace farrier::locomotion {
namespace joint_guard_test {

constexpr double kPeriod_s = 1e-3;
constexpr int kLegs = 4;

/// A guard whose joints have the torques commanded two ticks ago, but one.
class Joints {
 public:
  Joints() {
    readings_.legs.fill({});
    asked_.fill(Eigen::Vector3d::Zero());
    late_ = asked_;
  }

  /// For so long the knee of leg 1 is off by this torque and has this velocity. Others are asked for a wave.
  void go(double seconds, double off_Nm, double velocity_rad_s, JointDuty duty = JointDuty::kWalk) {
    for (int tick = 0; tick < std::lround(seconds / kPeriod_s); ++tick) {
      for (int leg = 0; leg < kLegs; ++leg) {
        readings_.legs[leg].torque_Nm = late_[leg];
      }
      readings_.legs[1].torque_Nm[2] += off_Nm;
      readings_.legs[1].velocity_rad_s[2] = velocity_rad_s;
      late_ = asked_;
      guard_.step(readings_, late_, duty);
      ++now_;
      asked_.fill(Eigen::Vector3d::Constant(amplitude_Nm_ * std::sin(0.05 * static_cast<double>(now_))));
    }
  }
  void ask(double amplitude_Nm) { amplitude_Nm_ = amplitude_Nm; }
  JointGuard& guard() { return guard_; }

 private:
  JointGuard guard_{{}, {140.0, 140.0, 140.0}, kLegs, kPeriod_s};
  Readings readings_;
  LegTorques asked_, late_;
  double amplitude_Nm_ = 100.0;
  int now_ = 0;
};

TEST(JointGuard, RaisesNoAlarmForJointsThatFollow) {
  Joints joints;
  joints.go(2.0, 10.0, 0.0);
  EXPECT_FALSE(joints.guard().dead());
}

TEST(JointGuard, FindsAJointThatNeitherFollowsNorMoves) {
  Joints joints;
  joints.go(1.0, 0.0, 0.0);
  joints.go(0.050, 30.0, 0.0);
  EXPECT_FALSE(joints.guard().dead());
  joints.go(0.015, 30.0, 0.03);
  EXPECT_EQ(joints.guard().dead(), (LegJoint{1, 2}));
}

TEST(JointGuard, GivesARobotThatStandsTheTimeToFindAWideOverlap) {
  Joints joints;
  joints.go(0.9, 30.0, 0.0, JointDuty::kStand);
  EXPECT_FALSE(joints.guard().dead());
  joints.go(2.0, 0.0, 0.0, JointDuty::kStand);
  joints.go(1.1, 30.0, 0.0, JointDuty::kStand);
  EXPECT_EQ(joints.guard().dead(), (LegJoint{1, 2}));
}

TEST(JointGuard, FollowsAForceLoopThatSwingsAboutItsCommand) {
  Joints joints;
  for (int period = 0; period < 200; ++period) {
    joints.go(0.005, 40.0, 0.0);
    joints.go(0.005, -40.0, 0.0);
  }
  EXPECT_FALSE(joints.guard().dead());
}

TEST(JointGuard, LearnsNothingFromAStillJointThatIsAskedForLittle) {
  Joints joints;
  joints.ask(0.0);
  joints.go(0.030, 50.0, 0.0);
  joints.go(1.000, 0.0, 0.0);
  EXPECT_FALSE(joints.guard().dead());
  joints.go(0.030, 50.0, 0.0);
  EXPECT_EQ(joints.guard().dead(), (LegJoint{1, 2}));
}

TEST(JointGuard, TakesAJointThatMovesForAWeakOne) {
  Joints joints;
  joints.go(2.0, 60.0, 0.5);
  EXPECT_FALSE(joints.guard().dead());
}

TEST(JointGuard, ForgetsATouchdown) {
  Joints joints;
  for (int stride = 0; stride < 20; ++stride) {
    joints.go(0.030, 80.0, 0.0);
    joints.go(0.060, 0.0, 0.5);
  }
  EXPECT_FALSE(joints.guard().dead());
}

TEST(JointGuard, IgnoresJointsThatNeedNotFollow) {
  Joints joints;
  joints.go(2.0, 100.0, 0.0, JointDuty::kNone);
  EXPECT_FALSE(joints.guard().dead());
  joints.go(0.040, 100.0, 0.0);
  EXPECT_FALSE(joints.guard().dead()) << "it counts from then on";
}

TEST(JointGuard, TakesNoNumberForNoAlarm) {
  Joints joints;
  joints.go(1.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_FALSE(joints.guard().dead());
}

TEST(JointGuard, LiesDownUntilTheOperatorAsksARobotThatLiesToLie) {
  const MotionCommand trot{.request = Request::kTrot, .forward_m_s = 0.4}, lie{.request = Request::kLie};
  Joints joints;
  EXPECT_EQ(joints.guard().command(trot, false).request, Request::kTrot);
  joints.go(0.1, 30.0, 0.0);
  const MotionCommand acts = joints.guard().command(trot, false);
  EXPECT_EQ(acts.request, Request::kLie);
  EXPECT_TRUE(acts.at_once);
  EXPECT_EQ(joints.guard().command(lie, false).request, Request::kLie);
  EXPECT_EQ(joints.guard().command(trot, true).request, Request::kLie) << "an operator has to ask to lie";
  joints.guard().command(lie, true);
  EXPECT_FALSE(joints.guard().dead());
  EXPECT_EQ(joints.guard().command(trot, true).request, Request::kTrot);
}

}  // namespace joint_guard_test
}  // namespace farrier::locomotion
