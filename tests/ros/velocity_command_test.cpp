// farrier ros --commands beside a robot on a ground: a node of ROS 2 steers it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/ros/sender.hpp"
#include "tests/ros/user_node.hpp"
#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace velocity_command_test {

using namespace std::chrono_literals;
using ros_messages::geometry_msgs::Twist;
using ros_messages::nav_msgs::Odometry;
using ros_messages::tf2_msgs::TFMessage;

constexpr int kRosDomain = 64;
constexpr auto kPatience = 90s;

// The trot's own script walks forward; the first node asks for the other way.
TEST(VelocityCommand, NodesOfBothVendorsMakeAWalkingRobotTurn) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "ideal", "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  trot.renice(5);  // in lock-step it takes all of the processors that others leave
  FarrierCommand ros({"ros", "--domain", std::to_string(trot.domain()), "--ros-domain", std::to_string(kRosDomain),
                      "--ros-address", "127.0.0.1", "--commands", "--tf"});
  ASSERT_TRUE(ros.says("commands are taken from any node")) << ros.output();
  UserNode user(kRosDomain);
  auto odometry = user.node().reader<Odometry>("odom", {.reliable = false, .depth = 1}).value();
  auto transforms = user.node().reader<TFMessage>("/tf", {.depth = 100}).value();
  double forward_m_s = 0.0;
  std::string child_frame;
  // Each vendor's node turns the robot to the other side, when the one before is silent.
  double wanted_m_s = -0.3;
  for (const std::string& vendor : sender_vendors()) {
    const auto velocities = sender_of<Twist>(vendor, kRosDomain, "/hyq/cmd_vel");
    EXPECT_TRUE(user.until([&] { return forward_m_s * wanted_m_s > 0.5 * wanted_m_s * wanted_m_s; },
                           [&] {
                             Twist twist;
                             twist.linear.x = wanted_m_s;
                             velocities->send(twist);
                             odometry.take([&](const Odometry& message, std::uint64_t) {
                               forward_m_s = message.twist.twist.linear.x;
                               EXPECT_EQ(message.child_frame_id, "base_link");
                             });
                             transforms.take([&](const TFMessage& message, std::uint64_t) {
                               child_frame = message.transforms.at(0).child_frame_id;
                             });
                           },
                           kPatience))
        << vendor << ": " << forward_m_s << "\n"
        << ros.output();
    wanted_m_s = -wanted_m_s;
  }
  EXPECT_EQ(child_frame, "base_link");
  ros.signal(SIGINT);
  EXPECT_EQ(ros.wait(), 130);
  trot.renice(0);
  trot.signal(SIGINT);
  trot.wait();
}

}  // namespace velocity_command_test
}  // namespace farrier::test
