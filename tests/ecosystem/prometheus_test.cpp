// Debian's Prometheus: it scrapes a monitor beside a running trot, and takes the alert rules.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/support/http_get.hpp"
#include "tests/system/beside_a_trot.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::test {
namespace prometheus_test {

using namespace std::chrono_literals;
using nlohmann::json;

/// Where a program is; empty where it is not installed.
std::string find_program(const std::string& name) {
  for (const char* folder : {"/usr/bin/", "/usr/local/bin/"}) {
    if (std::filesystem::exists(folder + name)) {
      return folder + name;
    }
  }
  return {};
}

#define FARRIER_NEEDS_PROMETHEUS()                                \
  if (find_program("prometheus").empty()) {                       \
    GTEST_SKIP() << "no prometheus here: apt install prometheus"; \
  }

const std::string kMonitoring = FARRIER_MONITORING;

TEST(AlertRules, AreWhatPromtoolTakesAndFireWhenTheyShould) {
  FARRIER_NEEDS_PROMETHEUS();
  const ScratchDirectory scratch;
  const std::vector<std::vector<std::string>> checks{{"check", "rules", "farrier.rules.yml"},
                                                     {"check", "config", "prometheus.yml"},
                                                     {"test", "rules", "farrier.rules.test.yml"}};
  for (const std::vector<std::string>& check : checks) {
    const auto ran = run_tool({"promtool", "prometheus"}, check, kMonitoring, scratch.file("said"));
    EXPECT_TRUE(ran.ok()) << ran.error().message;
  }
}

class Prometheus : public BesideATrot {
 protected:
  /// Prometheus's answer to a query, once it has one that is `wanted`; the last one otherwise.
  static std::string answer(std::uint16_t port, const std::string& query, const std::string& wanted) {
    const auto until = std::chrono::steady_clock::now() + 90s;
    std::string value;
    while (value != wanted && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(500ms);
      const json said = json::parse(http_get(port, "/api/v1/query?query=" + query), nullptr, false);
      if (!said.is_discarded() && said.value("status", "") == "success" && !said["data"]["result"].empty()) {
        value = said["data"]["result"][0]["value"][1].get<std::string>();
      }
    }
    return value;
  }
};

TEST_F(Prometheus, ScrapesTwelveJointsOfARobotThatRuns) {
  FARRIER_NEEDS_PROMETHEUS();
  for_both_vendors([](const std::string& vendor) {
    const std::uint16_t metrics = free_port();
    std::vector<std::string> arguments = beside(vendor);
    arguments.insert(arguments.begin(), {"monitor", "--prometheus", "127.0.0.1:" + std::to_string(metrics)});
    FarrierCommand monitor(arguments);
    ASSERT_TRUE(monitor.says("/metrics")) << monitor.output();

    const ScratchDirectory scratch;
    std::ofstream(scratch.file("prometheus.yml"))
        << "global: {scrape_interval: 1s, evaluation_interval: 1s}\n"
        << "rule_files: [" << kMonitoring << "/farrier.rules.yml]\n"
        << "scrape_configs:\n"
        << "  - job_name: farrier\n"
        << "    static_configs: [{targets: ['127.0.0.1:" << metrics << "']}]\n";
    const std::uint16_t web = free_port();
    FarrierCommand prometheus(
        {"--config.file=" + scratch.file("prometheus.yml"), "--storage.tsdb.path=" + scratch.file("data"),
         "--web.listen-address=127.0.0.1:" + std::to_string(web), "--log.level=warn"},
        {.executable = find_program("prometheus"), .prepare = {}});
    EXPECT_EQ(answer(web, "count(farrier_joint_control_rate_hertz%3E0)", "12"), "12") << prometheus.output();
    EXPECT_EQ(answer(web, "up", "1"), "1");
    EXPECT_EQ(answer(web, "count(farrier_joint_state%7Bstate=%22tracking%22%7D==1)", "12"), "12");
    EXPECT_EQ(answer(web, "farrier_monitor_info%7Brobot=%22hyq%22%7D", "1"), "1");
    EXPECT_EQ(answer(web, "count(scrape_samples_scraped%3E100)", "1"), "1");
    const json rules = json::parse(http_get(web, "/api/v1/rules"), nullptr, false);
    ASSERT_FALSE(rules.is_discarded());
    EXPECT_EQ(rules["data"]["groups"].size(), 3u);

    monitor.signal(SIGINT);
    EXPECT_EQ(monitor.wait(20s), 130) << monitor.output();
    EXPECT_EQ(answer(web, "up", "0"), "0");
    prometheus.signal(SIGTERM);
    EXPECT_EQ(prometheus.wait(60s), 0) << prometheus.output();
  });
}

}  // namespace prometheus_test
}  // namespace farrier::test
