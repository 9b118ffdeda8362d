// farrier ros beside a trot: a node of ROS 2 gets joint states, description, clock and log.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/ros/user_node.hpp"
#include "tests/system/farrier_command.hpp"
#include "urdf/urdf_reader.hpp"

namespace farrier::test {
namespace ros_command_test {

using namespace std::chrono_literals;
namespace msgs = ros_messages;

constexpr int kRosDomain = 63;
constexpr auto kPatience = 60s;

/// A node of a user, and what it has heard.
class User {
 public:
  /// Calls `done` often until it is true, while messages are taken.
  template <class Done>
  bool hears(Done&& done) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end) {
      joints_.take([this](const msgs::sensor_msgs::JointState& message, std::uint64_t) { joints.push_back(message); });
      description_.take([this](const msgs::std_msgs::String& message, std::uint64_t) { description = message.data; });
      clock_.take([this](const msgs::rosgraph_msgs::Clock& message, std::uint64_t) { clock = message; });
      diagnostics_.take([this](const auto& message, std::uint64_t) { diagnostics = message; });
      log_.take([this](const msgs::rcl_interfaces::Log& message, std::uint64_t) { log += message.msg + "\n"; });
      if (done()) {
        return true;
      }
      std::this_thread::sleep_for(5ms);
    }
    return false;
  }
  std::uint64_t lost() const { return joints_.raw().lost(); }

  std::vector<msgs::sensor_msgs::JointState> joints;
  std::string description;
  std::optional<msgs::rosgraph_msgs::Clock> clock;
  std::optional<msgs::diagnostic_msgs::DiagnosticArray> diagnostics;
  std::string log;  ///< texts of /rosout, a line each

 private:
  bus_ros::RosNode node_ =
      bus_ros::RosNode::create({.network = {.domain = kRosDomain, .address = "127.0.0.1", .peers = {}},
                                .name = "user",
                                .ros_namespace = "/",
                                .graph = bus_ros::Graph::kJazzy})
          .value();
  bus_ros::RosReader<msgs::sensor_msgs::JointState> joints_ =
      node_.reader<msgs::sensor_msgs::JointState>("/hyq/joint_states", {.depth = 1000}).value();
  bus_ros::RosReader<msgs::std_msgs::String> description_ =
      node_.reader<msgs::std_msgs::String>("/hyq/robot_description", {.transient_local = true, .depth = 1}).value();
  bus_ros::RosReader<msgs::rosgraph_msgs::Clock> clock_ =
      node_.reader<msgs::rosgraph_msgs::Clock>("/clock", {.reliable = false, .depth = 1}).value();
  bus_ros::RosReader<msgs::diagnostic_msgs::DiagnosticArray> diagnostics_ =
      node_.reader<msgs::diagnostic_msgs::DiagnosticArray>("/diagnostics", {.depth = 10}).value();
  bus_ros::RosReader<msgs::rcl_interfaces::Log> log_ =
      node_.reader<msgs::rcl_interfaces::Log>("/rosout", {.transient_local = true, .depth = 1000}).value();
};

std::int64_t ns_of(const msgs::builtin_interfaces::Time& time) {
  return std::int64_t{time.sec} * 1'000'000'000 + time.nanosec;
}

TEST(RosCommand, ANodeGetsJointStatesWithoutAGapAndTheDescriptionAsALateJoiner) {
  const ScratchDirectory scratch;
  FarrierCommand trot({"trot", "--world", "bench", "--duration", "600", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick 0 of")) << trot.output();
  trot.renice(5);  // in lock-step it takes all of the processors that others leave
  FarrierCommand ros({"ros", "--domain", std::to_string(trot.domain()), "--ros-domain", std::to_string(kRosDomain),
                      "--ros-address", "127.0.0.1", "--sim-time"});
  ASSERT_TRUE(ros.says("commands are refused")) << ros.output();
  FarrierCommand second({"ros", "--domain", std::to_string(trot.domain()), "--ros-domain", std::to_string(kRosDomain),
                         "--ros-address", "127.0.0.1", "--ros-namespace", "/second"});
  ASSERT_TRUE(second.says("commands are refused")) << second.output();
  User user;
  ASSERT_TRUE(user.hears([&] { return user.joints.size() >= 100 && user.clock && user.diagnostics; })) << ros.output();
  EXPECT_EQ(user.lost(), 0u);
  for (std::size_t i = 0; i < user.joints.size(); ++i) {
    const msgs::sensor_msgs::JointState& message = user.joints[i];
    EXPECT_LE(message.name.size(), 12u);
    EXPECT_EQ(message.position.size(), message.name.size());
    if (i > 0) {
      EXPECT_GT(ns_of(message.header.stamp), ns_of(user.joints[i - 1].header.stamp));
    }
  }
  EXPECT_EQ(user.joints.back().name.size(), 12u);
  EXPECT_EQ(user.joints.back().name.front(), "lf_haa");
  ASSERT_TRUE(user.hears([&] { return !user.description.empty(); }));
  const auto urdf = urdf::read_urdf_text(user.description, "robot_description");
  ASSERT_TRUE(urdf.ok());
  for (const std::string& name : user.joints.back().name) {
    EXPECT_TRUE(std::ranges::any_of(urdf.value().joints, [&](const auto& joint) { return joint.name == name; }))
        << name;
  }
  EXPECT_TRUE(ros.says("this node has its name for nodes of Iron and later")) << ros.output();
  UserNode beside(kRosDomain, "/second");
  EXPECT_TRUE(beside.until([&] { return beside.angle_rad("rh_kfe").has_value(); })) << second.output();
  const auto humble = bus_ros::RosNode::create({.network = {.domain = kRosDomain, .address = "127.0.0.1", .peers = {}},
                                                .name = "humble",
                                                .ros_namespace = "/",
                                                .graph = bus_ros::Graph::kHumble});
  ASSERT_TRUE(humble.ok());
  EXPECT_TRUE(user.hears([&] { return user.log.find("nodes of Humble and of a later ROS 2") != std::string::npos; }))
      << user.log << ros.output();
  second.signal(SIGINT);
  EXPECT_EQ(second.wait(), 130);
  ros.signal(SIGINT);
  EXPECT_EQ(ros.wait(), 130);
  EXPECT_NE(ros.output().find("0 dropped for slow readers"), std::string::npos) << ros.output();
  trot.renice(0);
  trot.signal(SIGINT);
  trot.wait();
}

TEST(RosCommand, RefusesWhatItCannotDo) {
  std::string output;
  EXPECT_EQ(run_farrier({"ros", "--robot", std::string(FARRIER_ROBOTS) + "/fc1d.yaml", "--commands"}, &output), 2);
  EXPECT_NE(output.find("--commands: "), std::string::npos) << output;
  const auto refuses = [&](const std::vector<std::string>& arguments, const char* why) {
    std::vector<std::string> all{"ros"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(run_farrier(all, &output), 2);
    EXPECT_NE(output.find(why), std::string::npos) << output;
  };
  refuses({"--ros-namespace", "hyq/"}, "give / or a name like /hyq");
  refuses({"--ros-address", "here"}, "--ros-address");
  refuses({"--ros-peers", "no such host"}, "--ros-peers");
  refuses({"--allow-arm"}, "--commands");
  for (const auto& [name, value] : {std::pair{"ROS_DOMAIN_ID", "5x"},
                                    {"ROS_DOMAIN_ID", "233"},
                                    {"ROS_AUTOMATIC_DISCOVERY_RANGE", "EVERYWHERE"},
                                    {"ROS_STATIC_PEERS", "no such host"}}) {
    ::setenv(name, value, 1);
    refuses({}, name);
    ::unsetenv(name);
  }
}

}  // namespace ros_command_test
}  // namespace farrier::test
