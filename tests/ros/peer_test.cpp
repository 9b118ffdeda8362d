// A node of RTPS from npm, which nobody at Farrier wrote, finds a robot by multicast and reads it.

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/ros/robot_with_node.hpp"
#include "tests/support/network_namespaces.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::test {
namespace peer_test {

using nlohmann::json;

constexpr const char* kRosDomain = "5";
constexpr double kRate_Hz = 100.0;

/// True if others leave this computer time. The node is an observer with the lowest priority, so on a crowded computer its
/// times and rates are those of the crowd.
bool has_time() {
  double load = 0.0;
  const bool known = ::getloadavg(&load, 1) == 1;
  const bool has = known && load < 1.5 * std::thread::hardware_concurrency();
  if (!has) {
    std::printf("times and rates are not judged: %.1f processes want to run\n", load);
  }
  return has;
}

class RosPeer : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    refusal_ = NetworkNamespaces::refusal();
    if (!refusal_.empty()) {
      return;
    }
    // The loopback interface of a namespace of its own has multicast, which that of a computer has not.
    ASSERT_EQ(::unshare(CLONE_NEWNET), 0);
    ASSERT_EQ(std::system("ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo"), 0);
    robot_ = std::make_unique<RobotWithNode>();
    robot_->start({"--world", "bench", "--clock", "realtime", "--no-comparison"},
                  {"--ros-domain", kRosDomain, "--ros-discovery", "subnet", "--graph", "jazzy", "--tf"},
                  "commands are refused");
  }
  static void TearDownTestSuite() { robot_.reset(); }
  void SetUp() override {
    if (!refusal_.empty()) {
      GTEST_SKIP() << refusal_;
    }
  }

  /// Has the peer look, and read joint states for so long; what it has seen.
  static json look(int seconds) {
    const std::string output = robot_->scratch().file("peer.json");
    const auto ran = run_tool({"node", "nodejs"}, {"peer.mjs", kRosDomain, "/hyq", std::to_string(seconds)},
                              FARRIER_ECOSYSTEM, output);
    EXPECT_TRUE(ran.ok()) << ran.error().message;
    return json::parse(std::ifstream(output));
  }

  /// Joint states of so many seconds came at their rate, and none is missing.
  static void expect_joint_states(const json& joints, int seconds) {
    EXPECT_EQ(joints.at("missing"), 0);
    EXPECT_EQ(joints.at("names"), 12);
    EXPECT_TRUE(joints.at("finite"));
    EXPECT_GT(joints.at("count").get<double>(), 0.0);
    if (has_time()) {
      EXPECT_EQ(joints.at("backwards"), 0) << "a stamp is before the last";
      EXPECT_GE(joints.at("count").get<double>(), 0.95 * kRate_Hz * seconds);
    }
  }

  static inline std::string refusal_;
  static inline std::unique_ptr<RobotWithNode> robot_;
};

TEST_F(RosPeer, FindsTopicsTypesQosAndNodeAndReadsThemWithoutAGap) {
  const json seen = look(5);
  ASSERT_EQ(seen.at("participants").size(), 1u);
  EXPECT_EQ(seen.at("participants")[0].at("userData"), "enclave=/;");
  const json& topics = seen.at("topics");
  ASSERT_TRUE(topics.contains("rt/hyq/joint_states")) << seen;
  const json& states = topics.at("rt/hyq/joint_states");
  EXPECT_EQ(states.at("type"), "sensor_msgs::msg::dds_::JointState_");
  EXPECT_TRUE(states.at("reliable"));
  EXPECT_FALSE(states.at("kept"));
  EXPECT_EQ(states.at("userData"), "typehash=RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e;");
  EXPECT_TRUE(topics.at("rt/hyq/robot_description").at("kept"));
  EXPECT_TRUE(topics.contains("rt/hyq/lf_foot/wrench"));
  EXPECT_EQ(topics.at("rt/tf").at("type"), "tf2_msgs::msg::dds_::TFMessage_");
  const json& nodes = seen.at("graph").at("nodes");
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].at("namespace"), "/hyq");
  EXPECT_EQ(nodes[0].at("name"), "farrier");
  for (const auto& [name, topic] : topics.items()) {
    if (name != "ros_discovery_info") {
      const json& writers = nodes[0].at("writers");
      EXPECT_NE(std::ranges::find(writers, topic.at("guid")), writers.end()) << name << " is of no node";
    }
  }
  EXPECT_GT(seen.at("description").get<int>(), 5000);
  if (has_time()) {
    EXPECT_LT(seen.at("participants")[0].at("found_s").get<double>(), 2.0);
    EXPECT_LT(seen.at("description_s").get<double>(), 1.0);
  }
  expect_joint_states(seen.at("joints"), 5);
}

TEST_F(RosPeer, ReadsJointStatesForAMinuteWithoutAGap) { expect_joint_states(look(60).at("joints"), 60); }

}  // namespace peer_test
}  // namespace farrier::test
