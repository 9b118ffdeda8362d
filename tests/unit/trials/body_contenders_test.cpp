#include "trials/body/body_contenders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace farrier::trials {
namespace body_contenders_test {

robot::Robot hyq(bool on_ground) {
  return robot::load_robot(FARRIER_ROBOTS "hyq.yaml", {.on_ground = on_ground}).value();
}

/// The first walk that is compared, for ten seconds of trot.
TrotCase ten_seconds(const robot::Robot& robot) {
  TrotCase one = compared_cases(robot, 1).front();
  one.judged_until_s = one.end_s = one.trot_s + 10.0;
  return one;
}

const BodyContender& find(const std::vector<BodyContender>& contenders, const std::string& name) {
  return *std::ranges::find(contenders, name, &BodyContender::name);
}

TEST(ForceControllers, WalkOnLqrForTheLoadsOfTheMassMatrixAndFallWithThoseOfTheBench) {
  const auto contenders = force_controllers(hyq(true), hyq(false));
  const auto fell = [&contenders](const char* name) {
    const robot::Robot& robot = find(contenders, name).robot;
    return run_trot_case(robot, ten_seconds(robot), Joints::kActuators).value().value().fell_s.has_value();
  };
  EXPECT_FALSE(fell("lqr"));
  EXPECT_TRUE(fell("lqr_bench"));
}

TEST(ForceControllers, AreRefusedForADesignThatDoesNotExist) {
  const auto contenders = force_controllers(hyq(true), hyq(false));
  const robot::Robot& robot = find(contenders, "lqr_full").robot;
  const auto ran = run_trot_case(robot, ten_seconds(robot), Joints::kActuators);
  ASSERT_FALSE(ran.ok());
  EXPECT_NE(ran.error().message.find("lf_haa: no controller"), std::string::npos) << ran.error().message;
}

TEST(ForceLimits, RemoveOneDisturbanceEach) {
  const robot::Robot file = hyq(true);
  const auto limits = limits_of_force(file);
  EXPECT_EQ(find(limits, "no_noise").robot.joints[0].noise.force, 0.0);
  EXPECT_EQ(find(limits, "no_noise").robot.joints[0].effects, file.joints[0].effects);
  EXPECT_EQ(find(limits, "no_delay").robot.loop_delay_lockstep, 0);
  EXPECT_FALSE(find(limits, "constant_supply").robot.supply.has_value());
  EXPECT_EQ(find(limits, "no_friction").robot.joints[0].effects.size() + 1, file.joints[0].effects.size());
  EXPECT_EQ(find(limits, "no_overlap").robot.joints[0].effects.size() + 1, file.joints[0].effects.size());
  EXPECT_EQ(find(limits, "no_valve_lag").robot.joints[0].effects.size() + 1, file.joints[0].effects.size());
  EXPECT_GT(find(limits, kPerfectKnowledge).robot.joints[0].noise.force, 0.0);
}

}  // namespace body_contenders_test
}  // namespace farrier::trials
