#include <gtest/gtest.h>

#include "test_files.hpp"

namespace farrier::robot {
namespace deployment_test {

// One change to the deployment of hyq.yaml and the problem it must cause, at the line of `at`.
struct Mistake {
  const char* from;
  const char* to;
  const char* at;
  const char* problem;
};

void PrintTo(const Mistake& mistake, std::ostream* stream) { *stream << mistake.to; }

class DeploymentMistake : public testing::TestWithParam<Mistake> {};

TEST_P(DeploymentMistake, IsReportedWithItsLineAndRemedy) {
  const std::string text = replaced(text_of("hyq"), GetParam().from, GetParam().to);
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  EXPECT_EQ(to_string(robot.error()),
            "hyq.yaml:" + std::to_string(line_of(text, GetParam().at)) + ": " + GetParam().problem + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    All, DeploymentMistake,
    testing::Values(
        Mistake{"[lf_haa, lf_hfe, lf_kfe], cpus", "[lf_haa, lf_hfe], cpus", "hosts:\n    front",
                "deployment.hosts: no joint_node has joint lf_kfe: add it to the joints of one"},
        Mistake{"[rf_haa, rf_hfe, rf_kfe], cpus", "[rf_haa, rf_hfe, rf_kfe, lf_kfe], cpus", "rf_kfe, lf_kfe",
                "deployment.hosts.front.processes.joint_node_rf.joints: lf_kfe is hosted by process joint_node_lf too: "
                "it can be there once"},
        Mistake{"locomotion: {program: locomotion", "locomotion: {program: sim_bridge",
                "locomotion: {program: sim_bridge",
                "deployment.hosts.brain.processes.locomotion.program: sim_bridge is the program of process sim_bridge "
                "too: it can be there once"},
        Mistake{"        supervisor: {program: supervisor, cpus: [3]}\n", "", "hosts:\n    front",
                "deployment.hosts: no process has program supervisor: a robot needs one"},
        Mistake{"{program: supervisor, cpus: [3]}", "{program: supervisor, joints: [lf_haa]}", "joints: [lf_haa]}",
                "deployment.hosts.brain.processes.supervisor.joints: supervisor hosts none: only a joint_node does"},
        Mistake{"address: 192.168.20.12", "address: 192.168.20.11 # twice", "192.168.20.11 # twice",
                "deployment.hosts.hind.address: 192.168.20.11 is the address of host front too: it can be there once"},
        Mistake{"address: 192.168.20.12", "address: 127.0.0.1", "address: 127.0.0.1",
                "deployment.hosts.hind.address: 127.0.0.1 is every computer itself: give the address at which the "
                "other hosts reach it"},
        Mistake{"address: 192.168.20.12", "address: 239.255.0.1", "address: 239.255.0.1",
                "deployment.hosts.hind.address: 239.255.0.1 is no IPv4 address of a computer: give four numbers such "
                "as 192.168.10.11"},
        Mistake{"{program: sim_bridge, cpus: [1]}", "{program: sim_bridge, cpus: [1.5]}", "cpus: [1.5]",
                "deployment.hosts.brain.processes.sim_bridge.cpus: has a number that is not whole: give processors as "
                "/proc/cpuinfo counts them"}));

TEST(Deployment, MayBeLeftOut) { EXPECT_FALSE(load_shipped("fc1d").file.deployment.has_value()); }

TEST(Deployment, OfHyqSpreadsItsJointsOverTwoOfThreeHosts) {
  const Robot robot = load_shipped("hyq");
  ASSERT_TRUE(robot.file.deployment.has_value());
  const Deployment& deployment = *robot.file.deployment;
  ASSERT_EQ(deployment.hosts.size(), 3u);
  const DeployedProcess* lf = config::find(config::find(deployment.hosts, "front")->processes, "joint_node_lf");
  ASSERT_NE(lf, nullptr);
  EXPECT_EQ(lf->joints, (std::vector<std::string>{"lf_haa", "lf_hfe", "lf_kfe"}));
  EXPECT_EQ(lf->cpus, std::vector<int>{1});
  EXPECT_EQ(config::find(deployment.hosts, "brain")->vendor, Vendor::kFast);
}

TEST(Deployment, IsNoPartOfWhatMakesRobotsEqual) {
  const std::string text = replaced(text_of("hyq"), "address: 192.168.20.12", "address: 10.0.0.3");
  const auto moved = load_robot_text(text, "hyq.yaml");
  ASSERT_TRUE(moved.ok());
  EXPECT_EQ(configuration_hash(moved.value()), configuration_hash(load_shipped("hyq")));
}

TEST(Deployment, ListsAllItsMistakesAtOnce) {
  std::string text = replaced(text_of("hyq"), "joints: [lf_haa, lf_hfe, lf_kfe]", "joints: [lf_hfe, lf_kfx]");
  text = replaced(text, "address: 192.168.20.12", "address: 192.168.20.10");
  text = replaced(text, "        estimator_service: {program: estimator_service, cpus: [2]}\n", "");
  const auto robot = load_robot_text(text, "hyq.yaml");
  ASSERT_FALSE(robot.ok());
  std::vector<std::string> messages;
  for (const config::Problem& problem : robot.error()) {
    messages.push_back(problem.message);
  }
  const auto reports = [&](const std::string& message) {
    return std::find(messages.begin(), messages.end(), message) != messages.end();
  };
  EXPECT_EQ(messages.size(), 5u) << to_string(robot.error());
  EXPECT_TRUE(reports("lf_kfx is not a joint of a leg: did you mean lf_kfe?"));
  EXPECT_TRUE(reports("no joint_node has joint lf_haa: add it to the joints of one"));
  EXPECT_TRUE(reports("no joint_node has joint lf_kfe: add it to the joints of one"));
  EXPECT_TRUE(reports("192.168.20.10 is the address of host hind too: it can be there once"));
  EXPECT_TRUE(reports("no process has program estimator_service: a robot needs one"));
}

}  // namespace deployment_test
}  // namespace farrier::robot
