// farrier ros --commands beside a robot on a ground: a node of ROS 2 steers it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "bus_ros/ros_node.hpp"
#include "tests/system/farrier_command.hpp"

namespace farrier::test {
namespace velocity_command_test {

using namespace std::chrono_literals;
namespace msgs = ros_messages;

constexpr int kRosDomain = 64;
constexpr auto kPatience = 90s;

// The trot's own script walks forward; the node asks for the other way.
TEST(VelocityCommand, ANodeMakesAWalkingRobotTurnBack) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "ideal", "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  trot.renice(5);  // in lock-step it takes all of the processors that others leave
  FarrierCommand ros({"ros", "--domain", std::to_string(trot.domain()), "--ros-domain", std::to_string(kRosDomain),
                      "--ros-address", "127.0.0.1", "--commands"});
  ASSERT_TRUE(ros.says("commands are taken from any node")) << ros.output();
  auto node = bus_ros::RosNode::create({.network = {.domain = kRosDomain, .address = "127.0.0.1", .peers = {}},
                                        .name = "teleop",
                                        .ros_namespace = "/hyq",
                                        .graph = bus_ros::Graph::kJazzy})
                  .value();
  auto velocities = node.writer<msgs::geometry_msgs::Twist>("cmd_vel").value();
  auto odometry = node.reader<msgs::nav_msgs::Odometry>("odom", {.reliable = false, .depth = 1}).value();
  double forward_m_s = 0.0;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (forward_m_s > -0.15 && std::chrono::steady_clock::now() < end) {
    msgs::geometry_msgs::Twist twist;
    twist.linear.x = -0.3;
    velocities.write(twist);
    odometry.take([&](const msgs::nav_msgs::Odometry& message, std::uint64_t) {
      forward_m_s = message.twist.twist.linear.x;
      EXPECT_EQ(message.child_frame_id, "base_link");
    });
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_LE(forward_m_s, -0.15) << ros.output();
  ros.signal(SIGINT);
  EXPECT_EQ(ros.wait(), 130);
  trot.renice(0);
  trot.signal(SIGINT);
  trot.wait();
}

}  // namespace velocity_command_test
}  // namespace farrier::test
