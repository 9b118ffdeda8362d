// farrier monitor beside a running trot.

#include <gtest/gtest.h>

#include <regex>

#include "beside_a_trot.hpp"
#include "tests/support/http_get.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;

class Monitor : public BesideATrot {
 protected:
  static std::vector<std::string> monitor(const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"monitor"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::vector<std::string> where = beside();
    arguments.insert(arguments.end(), where.begin(), where.end());
    return arguments;
  }
};

/// Whether a line begins with these two cells.
bool has_row(const std::string& text, const std::string& first, const std::string& second) {
  return std::regex_search(text, std::regex("(^|\\n)" + first + " +" + second + " "));
}

TEST_P(Monitor, PrintsOneTableOfEveryJointAndProcess) {
  std::string output;
  ASSERT_EQ(run_farrier(monitor({"--once"}), &output), 0) << output;
  EXPECT_TRUE(output.starts_with("hyq  armed  tick ")) << output;
  for (const char* leg : {"lf", "rf", "lh", "rh"}) {
    for (const char* joint : {"haa", "hfe", "kfe"}) {
      EXPECT_TRUE(has_row(output, std::string(leg) + '_' + joint, "tracking")) << output;
    }
    EXPECT_TRUE(has_row(output, "joint_node_" + std::string(leg), "fast")) << output;
  }
}

TEST_P(Monitor, PrintsATableEverySecondWhereThereIsNoTerminal) {
  FarrierCommand command(monitor({}));
  EXPECT_TRUE(command.says("  tracking  ", 30s)) << command.output();
  EXPECT_TRUE(has_row(command.output(), "lf_haa", "tracking")) << command.output();
  command.signal(SIGTERM);
  EXPECT_EQ(command.wait(10s), 143);
}

TEST_P(Monitor, ServesMetricsWithoutATerminalAndPrintsNoTable) {
  const std::uint16_t port = free_port();
  const std::string address = "127.0.0.1:" + std::to_string(port);
  FarrierCommand command(monitor({"--prometheus", ":" + std::to_string(port)}));
  ASSERT_TRUE(command.says("metrics at http://" + address + "/metrics", 30s)) << command.output();
  const auto until = std::chrono::steady_clock::now() + 30s;
  std::string metrics;
  while (metrics.find("farrier_joint_state{") == std::string::npos && std::chrono::steady_clock::now() < until) {
    metrics = http_get(port, "/metrics");
  }
  EXPECT_NE(metrics.find("# TYPE farrier_joint_missed_ticks_total counter"), std::string::npos) << metrics;
  EXPECT_NE(metrics.find("farrier_joint_control_rate_hertz{leg=\"lf\",joint=\"lf_haa\"}"), std::string::npos) << metrics;
  std::string output;
  EXPECT_EQ(run_farrier(monitor({"--prometheus", address}), &output), 2);
  EXPECT_NE(output.find("--prometheus: cannot listen on " + address + ": Address already in use"), std::string::npos)
      << output;
  command.signal(SIGINT);
  EXPECT_EQ(command.wait(10s), 130);
  EXPECT_EQ(command.output().find("lf_haa"), std::string::npos) << command.output();
}

INSTANTIATE_TEST_SUITE_P(Over, Monitor, testing::Values("cyclone", "fast"),
                         [](const auto& dds) { return std::string(dds.param); });

TEST(MonitorCommand, RefusesWhatItCannotDo) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--prometheus", "9464"}, &output), 2);
  EXPECT_NE(output.find("--prometheus: '9464' is no address to listen on"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"monitor", "--prometheus", ":9464", "--once"}, &output), 2);
  EXPECT_EQ(run_farrier({"monitor", "--robot", "/nowhere.yaml"}, &output), 2);
}

TEST(MonitorCommand, SaysWhereToAskWhenNothingComes) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--once", "--domain", "99"}, &output), 1);
  EXPECT_NE(output.find("nothing comes in domain 99; why: farrier doctor --domain 99"), std::string::npos) << output;
}

}  // namespace
}  // namespace farrier::test
