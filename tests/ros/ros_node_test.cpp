// Nodes of ours against endpoints that a bare Cyclone DDS program opens as rmw_cyclonedds does.

#include "bus_ros/ros_node.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

namespace farrier::bus_ros {
namespace ros_node_test {

using namespace std::chrono_literals;
namespace msgs = ros_messages;

RosNode make_node(const std::string& name, Graph graph) {
  auto node = RosNode::create({.network = {.domain = 61, .address = "127.0.0.1", .peers = {}},
                               .name = name,
                               .ros_namespace = "/hyq",
                               .graph = graph});
  EXPECT_TRUE(node.ok()) << (node ? "" : node.error().message);
  return std::move(node).value();
}

/// Calls `done` often until it is true, for at most ten seconds.
bool comes(const std::function<bool()>& done) {
  for (int i = 0; i < 1000; ++i) {
    if (done()) {
      return true;
    }
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

TEST(RosNode, SamplesReachReadersThatAskForBestEffortAndForReliable) {
  RosNode robot = make_node("robot", Graph::kNone);
  RosNode user = make_node("user", Graph::kNone);
  auto writer = robot.writer<msgs::sensor_msgs::JointState>("joint_states").value();
  auto reliable = user.reader<msgs::sensor_msgs::JointState>("joint_states", {.depth = 100}).value();
  auto sensor_data =
      user.reader<msgs::sensor_msgs::JointState>("/hyq/joint_states", {.reliable = false, .depth = 5}).value();
  ASSERT_TRUE(comes([&] { return writer.raw().matched_readers() == 2; }));
  msgs::sensor_msgs::JointState sent;
  sent.header.stamp = {.sec = 3, .nanosec = 4};
  sent.name = {"lf_haa", "lf_hfe"};
  sent.position = {0.1, -0.2};
  ASSERT_TRUE(writer.write(sent));
  for (auto* reader : {&reliable, &sensor_data}) {
    std::vector<msgs::sensor_msgs::JointState> got;
    ASSERT_TRUE(comes([&] {
      reader->take([&](const auto& message, std::uint64_t) { got.push_back(message); });
      return !got.empty();
    }));
    EXPECT_EQ(got.front(), sent);
  }
}

TEST(RosNode, ALateJoinerGetsADescriptionOfTwoHundredKilobytes) {
  RosNode robot = make_node("robot", Graph::kNone);
  auto writer =
      robot.writer<msgs::std_msgs::String>("robot_description", {.transient_local = true, .depth = 1}).value();
  const std::string text(200'000, 'x');
  ASSERT_TRUE(writer.write({.data = text}));
  RosNode user = make_node("user", Graph::kNone);
  auto reader = user.reader<msgs::std_msgs::String>("robot_description", {.transient_local = true, .depth = 1}).value();
  std::string got;
  EXPECT_TRUE(comes([&] {
    reader.take([&](const msgs::std_msgs::String& message, std::uint64_t) { got = message.data; });
    return !got.empty();
  }));
  EXPECT_EQ(got, text);
}

// "auto": the first node says nothing until it sees the graph endpoint of another, whose form it takes.
TEST(RosNode, TheGraphMessageFollowsTheNodesThatAreThere) {
  for (const Graph form : {Graph::kJazzy, Graph::kHumble}) {
    RosNode robot = make_node("robot", Graph::kAuto);
    EXPECT_EQ(robot.look(), "");
    EXPECT_EQ(robot.acting_graph(), Graph::kNone);
    RosNode user = make_node("user", form);
    EXPECT_TRUE(comes([&] {
      robot.look();
      return robot.acting_graph() == form;
    }));
  }
}

TEST(RosNode, AmongNodesOfBothKindsTheGraphMessageStays) {
  RosNode humble = make_node("humble", Graph::kHumble);
  RosNode jazzy = make_node("jazzy", Graph::kJazzy);
  RosNode robot = make_node("robot", Graph::kAuto);
  std::string said;
  EXPECT_TRUE(comes([&] {
    const std::string text = robot.look();
    said = text.empty() ? said : text;
    return said.find("this node has no name") != std::string::npos;
  })) << said;
  EXPECT_EQ(robot.acting_graph(), Graph::kNone);
}

}  // namespace ros_node_test
}  // namespace farrier::bus_ros
