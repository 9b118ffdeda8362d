// farrier monitor beside a running trot.

#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <thread>

#include "beside_a_trot.hpp"
#include "tests/support/http_get.hpp"

namespace farrier::test {
namespace monitor_command_test {

using namespace std::chrono_literals;

class Monitor : public BesideATrot {
 protected:
  static std::vector<std::string> monitor(const std::vector<std::string>& options, const std::string& vendor) {
    std::vector<std::string> arguments{"monitor"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const std::vector<std::string> where = beside(vendor);
    arguments.insert(arguments.end(), where.begin(), where.end());
    return arguments;
  }
};

/// True if a line begins with these two cells.
bool has_row(const std::string& text, const std::string& first, const std::string& second) {
  return std::regex_search(text, std::regex("(^|\\n)" + first + " +" + second + " "));
}

TEST_F(Monitor, PrintsOneTableOfEveryJointAndProcess) {
  for_both_vendors([](const std::string& vendor) {
    std::string output;
    ASSERT_EQ(run_farrier(monitor({"--once"}, vendor), &output), 0) << output;
    EXPECT_TRUE(output.starts_with("hyq  armed  tick ")) << output;
    for (const char* leg : {"lf", "rf", "lh", "rh"}) {
      for (const char* joint : {"haa", "hfe", "kfe"}) {
        EXPECT_TRUE(has_row(output, std::string(leg) + '_' + joint, "tracking")) << output;
      }
      EXPECT_TRUE(has_row(output, "joint_node_" + std::string(leg), "fast")) << output;
    }
  });
}

TEST_F(Monitor, PrintsATableEverySecondWhereThereIsNoTerminal) {
  for_both_vendors([](const std::string& vendor) {
    FarrierCommand command(monitor({}, vendor));
    // The first table may be of what was heard of by then.
    const auto until = std::chrono::steady_clock::now() + 30s;
    while (!has_row(command.output(), "lf_haa", "tracking") && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(50ms);
    }
    EXPECT_TRUE(has_row(command.output(), "lf_haa", "tracking")) << command.output();
    command.signal(SIGTERM);
    EXPECT_EQ(command.wait(10s), 143);
  });
}

TEST_F(Monitor, ServesMetricsWithoutATerminalAndPrintsNoTable) {
  for_both_vendors([](const std::string& vendor) {
    const std::uint16_t port = free_port();
    const std::string address = "127.0.0.1:" + std::to_string(port);
    FarrierCommand command(monitor({"--prometheus", ":" + std::to_string(port)}, vendor));
    ASSERT_TRUE(command.says("metrics at http://" + address + "/metrics", 30s)) << command.output();
    const auto until = std::chrono::steady_clock::now() + 30s;
    std::string metrics;
    const std::string rate =
        "farrier_joint_control_rate_hertz{leg=\"lf\",joint=\"lf_haa\"}";  // of two summaries at least
    while (metrics.find(rate) == std::string::npos && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(50ms);
      metrics = http_get(port, "/metrics");
    }
    EXPECT_NE(metrics.find(rate), std::string::npos) << metrics;
    EXPECT_NE(metrics.find("# TYPE farrier_joint_missed_ticks_total counter"), std::string::npos) << metrics;
    std::string output;
    EXPECT_EQ(run_farrier(monitor({"--prometheus", address}, vendor), &output), 2);
    EXPECT_NE(output.find("--prometheus: cannot listen on " + address + ": Address already in use"), std::string::npos)
        << output;
    command.signal(SIGINT);
    EXPECT_EQ(command.wait(10s), 130);
    EXPECT_EQ(command.output().find("lf_haa"), std::string::npos) << command.output();
  });
}

class StoppedMonitors : public testing::TestWithParam<const char*> {};

// In lock-step a delayed writer blocks every process.
TEST_P(StoppedMonitors, HoldNoWriterBack) {
  constexpr int kMonitors = 10;
  const ScratchDirectory scratch;
  FarrierCommand trot(
      {"trot", "--world", "bench", "--dds", GetParam(), "--duration", "20", "--out", scratch.file("out")});
  ASSERT_TRUE(trot.says("trot: tick")) << trot.output();
  std::vector<std::unique_ptr<FarrierCommand>> monitors;
  for (int i = 0; i < kMonitors; ++i) {
    monitors.push_back(std::make_unique<FarrierCommand>(
        std::vector<std::string>{"monitor", "--domain", std::to_string(trot.domain()), "--dds", GetParam()}));
  }
  int listening = 0;
  for (const auto& monitor : monitors) {
    listening += monitor->says("  tracking  ", 30s) ? 1 : 0;
    monitor->signal(SIGSTOP);
  }
  EXPECT_EQ(listening, kMonitors);
  const std::size_t told = trot.output().size();  // a line for every tenth of the run
  const auto until = std::chrono::steady_clock::now() + 60s;
  while (trot.output().size() == told && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_GT(trot.output().size(), told);
  EXPECT_EQ(trot.output().find("waiting for"), std::string::npos) << trot.output();
  trot.signal(SIGINT);
  EXPECT_EQ(trot.wait(20s), 130) << trot.output();
}

INSTANTIATE_TEST_SUITE_P(Over, StoppedMonitors, testing::Values("cyclone", "fast"),
                         [](const auto& dds) { return std::string(dds.param); });

TEST(MonitorCommand, RefusesWhatItCannotDo) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--prometheus", "9464"}, &output), 2);
  EXPECT_NE(output.find("--prometheus: '9464' is no address to listen on"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"monitor", "--prometheus", ":9464", "--once"}, &output), 2);
  EXPECT_EQ(run_farrier({"monitor", "--robot", "/nowhere.yaml"}, &output), 2);
}

TEST(MonitorCommand, RefusesInvalidPorts) {
  std::string output;
  for (const char* port : {"0", "65536", "-1", ":8642", "http"}) {
    EXPECT_EQ(run_farrier({"monitor", "--port", port}, &output), 2) << port;
    EXPECT_NE(output.find("--port: "), std::string::npos) << output;
  }
}

TEST(MonitorCommand, RefusesAPortBesideTheOptionItIsShortFor) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--port", "8642", "--web", ":8643"}, &output), 2);
  EXPECT_NE(output.find("--web excludes --port"), std::string::npos) << output;
  EXPECT_EQ(run_farrier({"monitor", "--port", "8642", "--once"}, &output), 2);
}

TEST(MonitorCommand, SaysWhereToAskWhenNothingComes) {
  std::string output;
  EXPECT_EQ(run_farrier({"monitor", "--once", "--domain", "99"}, &output), 1);
  EXPECT_NE(output.find("nothing comes in domain 99; why: farrier doctor --domain 99"), std::string::npos) << output;
}

}  // namespace monitor_command_test
}  // namespace farrier::test
