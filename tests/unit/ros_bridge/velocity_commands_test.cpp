#include "tools/ros/velocity_commands.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace farrier::ros_bridge {
namespace velocity_commands_test {

using namespace std::chrono_literals;
using Twist = ros_messages::geometry_msgs::Twist;

constexpr Nanoseconds kTimeout = 300ms;
const SteadyTime kStart{10s};

Twist forward(double speed_m_s) {
  Twist twist;
  twist.linear.x = speed_m_s;
  return twist;
}

TEST(VelocityCommands, AVelocityIsATrotAndItsAbsenceIsSilence) {
  VelocityCommands commands(kTimeout);
  EXPECT_FALSE(commands.command(kStart, MotionMode::kStand).has_value());
  EXPECT_EQ(commands.take(forward(0.3), 1, kStart), "");
  const auto command = commands.command(kStart + 100ms, MotionMode::kStand);
  ASSERT_TRUE(command.has_value());
  EXPECT_EQ(command->request, MotionRequest::kTrot);
  EXPECT_EQ(command->forward_m_s, 0.3);
  EXPECT_FALSE(commands.command(kStart + kTimeout + 1ms, MotionMode::kTrot).has_value());
}

TEST(VelocityCommands, AVelocityOfZeroStandsAndWakesNoRobotThatLies) {
  VelocityCommands commands(kTimeout);
  EXPECT_EQ(commands.take(forward(0.0), 1, kStart), "");
  EXPECT_EQ(commands.command(kStart, MotionMode::kTrot)->request, MotionRequest::kStand);
  EXPECT_FALSE(commands.command(kStart, MotionMode::kLie).has_value());
  EXPECT_FALSE(commands.command(kStart, MotionMode::kFallen).has_value());
}

TEST(VelocityCommands, NumbersThatAreNotFiniteChangeNothing) {
  VelocityCommands commands(kTimeout);
  EXPECT_EQ(commands.take(forward(0.3), 1, kStart), "");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Twist twist;
    twist.angular.z = bad;
    EXPECT_NE(commands.take(twist, 1, kStart + 10ms), "");
  }
  EXPECT_EQ(commands.command(kStart + 20ms, MotionMode::kTrot)->forward_m_s, 0.3);
}

TEST(VelocityCommands, VelocitiesOutOfThePlaneAreRefused) {
  VelocityCommands commands(kTimeout);
  Twist twist;
  twist.linear.z = 0.1;
  EXPECT_NE(commands.take(twist, 1, kStart), "");
  EXPECT_FALSE(commands.command(kStart, MotionMode::kTrot).has_value());
}

TEST(VelocityCommands, ASecondSenderWaitsUntilTheFirstIsSilent) {
  VelocityCommands commands(kTimeout);
  EXPECT_EQ(commands.take(forward(0.3), 1, kStart), "");
  EXPECT_NE(commands.take(forward(-0.3), 2, kStart + 100ms), "");
  EXPECT_EQ(commands.command(kStart + 100ms, MotionMode::kTrot)->forward_m_s, 0.3);
  EXPECT_EQ(commands.take(forward(-0.3), 2, kStart + kTimeout + 1ms), "");
  EXPECT_EQ(commands.command(kStart + kTimeout + 1ms, MotionMode::kTrot)->forward_m_s, -0.3);
}

}  // namespace velocity_commands_test
}  // namespace farrier::ros_bridge
