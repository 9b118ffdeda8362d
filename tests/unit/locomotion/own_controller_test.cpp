// A controller of one's own: it stands the robot up.

#include <gtest/gtest.h>

#include "tests/unit/locomotion/point_foot_robot.hpp"
#include "docs/how-to/locomotion/stand_up.hpp"

namespace farrier::locomotion {
namespace own_controller_test {

TEST(OwnController, StandsTheRobotUp) {
  constexpr double kHip_m = 0.55;
  const LocomotionParams params = hyq_locomotion();
  PointFootRobot robot(params);
  StandUp controller(robot, robot.plan(), kHip_m);
  for (Tick tick = 0; tick < 5000; ++tick) {
    robot.step(controller.step(tick, robot.readings(), {}));
  }
  EXPECT_NEAR(robot.place_m().z(), kHip_m + params.estimator.foot_radius_m, 0.02);
  EXPECT_LT(robot.velocity_m_s().norm(), 0.01);
  EXPECT_GT(robot.rotation()(2, 2), 0.999);
}

}  // namespace own_controller_test
}  // namespace farrier::locomotion
