#include "locomotion/trot_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/locomotion/point_foot_robot.hpp"

namespace farrier::locomotion {
namespace trot_controller_test {

// A robot under its controller. Torques act one tick after their readings.
class Trial {
 public:
  Trial() : robot_(hyq_locomotion()), controller_(hyq_locomotion(), robot_.plan(), robot_) {}

  void go(double seconds, const MotionCommand& command, const Eigen::Vector3d& push_N = Eigen::Vector3d::Zero()) {
    for (double t = 0.0; t < seconds; t += PointFootRobot::kPeriod_s) {
      const LegTorques next = controller_.step(now_++, robot_.readings(), command);
      robot_.step(torques_, push_N);
      torques_ = next;
    }
  }
  PointFootRobot& robot() { return robot_; }
  TrotController& controller() { return controller_; }
  Mode mode() const { return controller_.state().mode; }

 private:
  PointFootRobot robot_;
  TrotController controller_;
  LegTorques torques_ = [] {
    LegTorques zero;
    zero.fill(Eigen::Vector3d::Zero());
    return zero;
  }();
  Tick now_ = 0;
};

TEST(TrotController, StandsUpTrotsStopsAndLiesDown) {
  Trial run;
  run.go(2.5, {.request = Request::kLie});
  EXPECT_EQ(run.mode(), Mode::kLie);
  run.go(5.0, {.request = Request::kStand});
  EXPECT_EQ(run.mode(), Mode::kStand);
  EXPECT_NEAR(run.robot().place_m().z(), hyq_locomotion().reference.default_height_m, 0.01);
  const double from = run.robot().place_m().x();
  run.go(10.0, {.request = Request::kTrot, .forward_m_s = 0.4});
  EXPECT_EQ(run.mode(), Mode::kTrot);
  EXPECT_NEAR(run.robot().place_m().x() - from, 0.4 * (10.0 - 0.4), 0.2);  // with the ramp of 0.8 s
  EXPECT_NEAR(run.robot().place_m().z(), hyq_locomotion().reference.default_height_m, 0.03);
  EXPECT_GT(run.robot().rotation()(2, 2), std::cos(0.05));
  run.go(4.0, {.request = Request::kStand});
  EXPECT_EQ(run.mode(), Mode::kStand);
  EXPECT_LT(run.robot().velocity_m_s().norm(), 0.02);
  run.go(5.0, {.request = Request::kLie});
  EXPECT_EQ(run.mode(), Mode::kLie);
  EXPECT_LT(run.robot().place_m().z(), 0.45);
}

// Valves at null hold the legs of a robot that stands, and its weight with them. When they are armed, a leg must not be
// pulled to the folded pose at once.
TEST(TrotController, WaitsWithTheSoftStartForJointsThatDoNotObey) {
  constexpr double kStep_Nm = 50.0, kWeightOfLeg_Nm = 5.0;  // of the torque at the time of arming
  for (const double held_Nm : {0.0, 30.0, 80.0}) {
    Trial run;
    Readings blocked = run.robot().readings();
    for (LegReadings& leg : blocked.legs) {
      leg.position_rad *= 0.5;  // of the folded pose
      leg.torque_Nm = {0.0, 0.0, held_Nm};
    }
    for (Tick tick = 0; tick < 6000; ++tick) {
      const LegTorques& torques = run.controller().step(tick, blocked, {.request = Request::kStand});
      for (int leg = 0; leg < PointFootRobot::kLegs; ++leg) {
        ASSERT_LE((torques[leg] - blocked.legs[leg].torque_Nm).cwiseAbs().maxCoeff(),
                  std::max(kStep_Nm, held_Nm) + kWeightOfLeg_Nm)
            << held_Nm << " Nm, tick " << tick;
      }
    }
    EXPECT_EQ(run.mode(), Mode::kLie);
    run.go(8.0, {.request = Request::kStand});
    EXPECT_EQ(run.mode(), Mode::kStand) << "the joints obey again";
  }
}

TEST(TrotController, EstimatesItsPlaceWithinTwoPercentOfTheDistance) {
  Trial run;
  run.go(2.5, {.request = Request::kLie});
  run.go(5.0, {.request = Request::kStand});
  const Eigen::Vector3d from = run.robot().place_m(), estimated = run.controller().state().trunk.position_m;
  run.go(15.0, {.request = Request::kTrot, .forward_m_s = 0.4});
  const Eigen::Vector3d way = run.robot().place_m() - from;
  EXPECT_LT((run.controller().state().trunk.position_m - estimated - way).head<2>().norm(), 0.02 * way.norm());
}

TEST(TrotController, SurvivesASidewaysPush) {
  Trial run;
  run.go(2.5, {.request = Request::kLie});
  run.go(5.0, {.request = Request::kStand});
  run.go(4.0, {.request = Request::kTrot});
  run.go(0.1, {.request = Request::kTrot}, {0.0, 600.0, 0.0});
  run.go(3.0, {.request = Request::kTrot});
  EXPECT_EQ(run.mode(), Mode::kTrot);
  EXPECT_GT(run.robot().rotation()(2, 2), std::cos(0.1));
  EXPECT_LT(run.robot().velocity_m_s().norm(), 0.3);
}

TEST(TrotController, AllocatesNothingInATick) {
  Trial run;
  run.go(2.5, {.request = Request::kLie});
  run.go(5.0, {.request = Request::kStand});
  const Readings readings = run.robot().readings();
  const test::AllocationGuard guard;
  for (Tick tick = 7500; tick < 9000; ++tick) {
    run.controller().step(tick, readings, {.request = Request::kTrot, .forward_m_s = 0.2});
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(TrotController, AnswersAnyReadingWithTorquesWithinTheLimits) {
  const LocomotionParams params = hyq_locomotion();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300}) {
    Trial run;
    run.go(2.5, {.request = Request::kLie});
    Readings readings = run.robot().readings();
    readings.legs[1].position_rad[2] = bad;
    readings.legs[2].velocity_rad_s[0] = bad;
    readings.imu.specific_force_m_s2[1] = bad;
    for (Tick tick = 2500; tick < 2520; ++tick) {
      const LegTorques& torques = run.controller().step(tick, readings, {.request = Request::kStand});
      for (int leg = 0; leg < PointFootRobot::kLegs; ++leg) {
        for (int joint = 0; joint < kJointsPerLeg; ++joint) {
          ASSERT_LE(std::abs(torques[leg][joint]), params.leg.torque_limit_Nm[joint]);
        }
      }
    }
  }
}

}  // namespace trot_controller_test
}  // namespace farrier::locomotion
