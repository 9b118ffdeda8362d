#include "tools/monitor/prometheus_metrics.hpp"

#include <gtest/gtest.h>
#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "feed.hpp"
#include "tests/support/http_get.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tools/monitor/listen_address.hpp"
#include "tools/monitor/prometheus_exposer.hpp"

namespace farrier::display {
namespace metrics_test {

using namespace monitor::testing;
using prometheus::MetricFamily;

constexpr double kDate_s = 1.7e9;

std::map<std::string, MetricFamily> by_name(const PrometheusMetrics& metrics) {
  std::map<std::string, MetricFamily> found;
  for (MetricFamily& family : metrics.Collect()) {
    found.emplace(family.name, family);
  }
  return found;
}

/// The value whose labels include all of these; fails without one.
double value(const MetricFamily& family, const std::vector<std::string>& labels) {
  for (const prometheus::ClientMetric& metric : family.metric) {
    const bool matches = std::ranges::all_of(labels, [&](const std::string& label) {
      return std::ranges::any_of(metric.label, [&](const auto& one) { return one.value == label; });
    });
    if (matches) {
      return family.type == prometheus::MetricType::Counter ? metric.counter.value : metric.gauge.value;
    }
  }
  ADD_FAILURE() << family.name << " has no such labels";
  return NAN;
}

class Metrics : public testing::Test {
 protected:
  Metrics() { walk_for_a_second(feed_); }
  void take() { metrics_.take(feed_.frame(), kDate_s); }

  Feed feed_;
  PrometheusMetrics metrics_{hyq()};
};

TEST_F(Metrics, AreNamedAsPrometheusWantsThem) {
  static const std::regex name("farrier_[a-z]+(_[a-z]+)+");
  std::set<std::string> names;
  for (const MetricSpec& spec : metric_specs()) {
    const std::string text = spec.name;
    EXPECT_TRUE(std::regex_match(text, name)) << text;
    EXPECT_EQ(text.ends_with("_total"), spec.kind == MetricKind::kCounter) << text;
    EXPECT_EQ(std::string(spec.help).back(), '.') << text;
    EXPECT_EQ(std::string(spec.help).find('|'), std::string::npos) << text << ": breaks its table";
    EXPECT_TRUE(names.insert(text).second) << text;
  }
}

TEST_F(Metrics, AreAllThereForARobotThatWalks) {
  take();
  const auto found = by_name(metrics_);
  for (const MetricSpec& spec : metric_specs()) {
    ASSERT_TRUE(found.contains(spec.name)) << spec.name;
    const std::size_t labels = static_cast<std::size_t>(
        std::ranges::count_if(spec.labels, [](const char* label) { return label != nullptr; }));
    std::set<std::vector<prometheus::ClientMetric::Label>> seen;
    for (const prometheus::ClientMetric& metric : found.at(spec.name).metric) {
      EXPECT_EQ(metric.label.size(), labels) << spec.name;
      EXPECT_TRUE(seen.insert(metric.label).second) << spec.name << " has a value twice";
    }
  }
  EXPECT_EQ(found.at("farrier_joint_control_rate_hertz").metric.size(), 12u);
  EXPECT_NEAR(value(found.at("farrier_joint_control_rate_hertz"), {"lf_hfe"}), 1000.0, 1e-3);
  EXPECT_EQ(value(found.at("farrier_joint_state"), {"lf_hfe", "tracking"}), 1.0);
  EXPECT_EQ(value(found.at("farrier_joint_state"), {"lf_hfe", "null"}), 0.0);
  EXPECT_NEAR(value(found.at("farrier_joint_load_mass_grams"), {"lf_hfe"}), 6000.0, 1e-3);
  EXPECT_EQ(value(found.at("farrier_robot_mode"), {"armed"}), 1.0);
  EXPECT_EQ(value(found.at("farrier_process_lost_samples_total"), {"joint_node_lf", "joint/sensors"}), 2.0);
  EXPECT_EQ(value(found.at("farrier_valve_command_latency_seconds"), {"sim_bridge", "99"}), 900e-6);
  EXPECT_EQ(value(found.at("farrier_monitor_frame_timestamp_seconds"), {}), kDate_s);
  EXPECT_EQ(value(found.at("farrier_events_total"), {"error"}), 1.0);
  metrics_.take(feed_.frame(), kDate_s + 60.0);
  EXPECT_EQ(value(by_name(metrics_).at("farrier_monitor_start_timestamp_seconds"), {}), kDate_s);
}

TEST_F(Metrics, SayNewtonsOfCylindersAndNewtonMetresOfMotors) {
  take();
  const auto found = by_name(metrics_);
  EXPECT_EQ(found.at("farrier_joint_force_error_newtons").metric.size(), 8u);
  EXPECT_EQ(found.at("farrier_joint_torque_error_newton_meters").metric.size(), 4u);
  EXPECT_EQ(value(found.at("farrier_joint_torque_error_newton_meters"), {"lf_haa"}), 10.0);
  EXPECT_EQ(value(found.at("farrier_joint_force_error_newtons"), {"lf_kfe"}), 10.0);
}

TEST_F(Metrics, CountAFaultThatComesAndGoesBetweenTwoScrapes) {
  take();
  for (int i = 0; i < 6; ++i) {
    feed_.walk(1020 + i * kTicksPerSummary, 1, [&](signals::JointSummary& s) {
      s.faults = s.joint == 1 && i % 2 == 0 ? static_cast<std::uint32_t>(Fault::kCommandStale) : 0;
    });
  }
  take();
  take();
  const auto found = by_name(metrics_);
  EXPECT_EQ(value(found.at("farrier_joint_fault_onsets_total"), {"lf_hfe", "command stale"}), 3.0);
  EXPECT_EQ(value(found.at("farrier_joint_fault_onsets_total"), {"lf_kfe", "command stale"}), 0.0);
  EXPECT_EQ(value(found.at("farrier_joint_fault"), {"lf_hfe", "command stale"}), 0.0);
}

TEST_F(Metrics, LeaveOutWhatIsNotKnown) {
  PrometheusMetrics metrics(hyq());
  EXPECT_TRUE(metrics.Collect().empty());
  Feed silent;
  metrics.take(silent.frame(), kDate_s);
  const auto found = by_name(metrics);
  EXPECT_FALSE(found.contains("farrier_joint_state"));
  EXPECT_FALSE(found.contains("farrier_joint_pole_modulus"));
  EXPECT_TRUE(std::isinf(value(found.at("farrier_monitor_last_sample_age_seconds"), {})));
}

TEST_F(Metrics, KeepProcessesApartThatCallThemselvesTheSame) {
  feed_.take(hello(3, "joint_node_lf"));
  feed_.take(hello(4, "bad\xff\n\""));
  take();
  const auto found = by_name(metrics_);
  EXPECT_EQ(value(found.at("farrier_process_info"), {"joint_node_lf (3)"}), 1.0);
  EXPECT_EQ(value(found.at("farrier_process_info"), {"bad??\""}), 1.0);
}

TEST_F(Metrics, AreFineByPromtool) {
  if (std::system("command -v promtool >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "no promtool: apt install prometheus";
  }
  take();
  const test::ScratchDirectory scratch;
  std::ofstream(scratch.file("metrics")) << prometheus::TextSerializer().Serialize(metrics_.Collect());
  const std::string command =
      "promtool check metrics <" + scratch.file("metrics") + " >" + scratch.file("said") + " 2>&1";
  const int status = std::system(command.c_str());
  std::ostringstream said;
  said << std::ifstream(scratch.file("said")).rdbuf();
  EXPECT_EQ(status, 0) << said.str();
}

TEST(AlertRules, NameOnlyMetricsThatThereAre) {
  std::set<std::string> names;
  for (const MetricSpec& spec : metric_specs()) {
    names.insert(spec.name);
  }
  std::ostringstream text;
  text << std::ifstream(FARRIER_MONITORING "farrier.rules.yml").rdbuf();
  const std::string rules = text.str();
  static const std::regex name("farrier_[a-z_]+");
  int found = 0;
  for (auto one = std::sregex_iterator(rules.begin(), rules.end(), name); one != std::sregex_iterator(); ++one) {
    EXPECT_TRUE(names.contains(one->str())) << one->str();
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST(AlertRules, ChooseFaultsBySeverityAndNotByName) {
  std::ostringstream text;
  text << std::ifstream(FARRIER_MONITORING "farrier.rules.yml").rdbuf();
  const std::string rules = text.str();
  static const std::regex by_name("fault *[!=]~?\"");
  EXPECT_FALSE(std::regex_search(rules, by_name));
  static const std::regex by_severity("farrier_joint_fault[a-z_]*\\{severity!?=\"([a-z]+)\"");
  int found = 0;
  for (auto one = std::sregex_iterator(rules.begin(), rules.end(), by_severity); one != std::sregex_iterator(); ++one) {
    EXPECT_TRUE(std::ranges::any_of(kFaults, [&](const FaultInfo& info) {
      return to_string(info.severity) == (*one)[1].str();
    })) << one->str();
    ++found;
  }
  EXPECT_EQ(found, 2);
}

TEST(AlertRules, AreTestedWithTheSeveritiesOfTheSafetyTable) {
  std::ostringstream text;
  text << std::ifstream(FARRIER_MONITORING "farrier.rules.test.yml").rdbuf();
  const std::string rules = text.str();
  static const std::regex series("farrier_joint_fault[^}]*fault=\"([^\"]+)\",severity=\"([a-z]+)\"");
  int found = 0;
  for (auto one = std::sregex_iterator(rules.begin(), rules.end(), series); one != std::sregex_iterator(); ++one) {
    const auto info =
        std::ranges::find(kFaults, (*one)[1].str(), [](const FaultInfo& row) { return std::string(row.name); });
    ASSERT_NE(info, kFaults.end()) << one->str();
    EXPECT_EQ(to_string(info->severity), (*one)[2].str()) << one->str();
    ++found;
  }
  EXPECT_EQ(found, 5);
}

TEST(MetricsTable, HasALineForEachMetric) {
  const std::string table = metrics_table_markdown();
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(table, '\n')), metric_specs().size() + 2);
  EXPECT_NE(table.find("| `farrier_joint_state` | gauge | `leg`, `joint`, `state` |"), std::string::npos) << table;
}

TEST(ListenAddress, IsThisComputerAloneUnlessToldOtherwise) {
  EXPECT_EQ(parse_listen_address(":9464").value().text(), "127.0.0.1:9464");
  EXPECT_EQ(parse_listen_address("localhost:9464").value().text(), "127.0.0.1:9464");
  EXPECT_EQ(parse_listen_address("0.0.0.0:80").value().text(), "0.0.0.0:80");
  EXPECT_EQ(parse_listen_address("[::1]:9464").value().text(), "[::1]:9464");
}

TEST(ListenAddress, RejectsInvalidAddresses) {
  for (const char* text :
       {"", "9464", ":", ":65536", ":94x", "1.2.3:9464", "robot:9464", "::1:9464", "[::1:9464", "127.0.0.1:9464 "}) {
    const auto address = parse_listen_address(text);
    ASSERT_FALSE(address.ok()) << text;
    EXPECT_NE(address.error().message.find("0.0.0.0:9464"), std::string::npos) << address.error().message;
  }
}

TEST(PrometheusExposer, RefusesAPortThatNobodyKnows) {
  const auto exposer = expose_to_prometheus({"127.0.0.1", 0, false}, hyq());
  ASSERT_FALSE(exposer.ok());
  EXPECT_NE(exposer.error().message.find(":9464"), std::string::npos) << exposer.error().message;
}

TEST(PrometheusExposer, ServesTheNewestFrame) {
  const ListenAddress address{"127.0.0.1", test::free_port(), false};
  const auto exposer = expose_to_prometheus(address, hyq());
  ASSERT_TRUE(exposer.ok()) << exposer.error().message;
  EXPECT_EQ(test::http_get(address.port, "/metrics").find("farrier_"), std::string::npos);
  Feed feed;
  walk_for_a_second(feed);
  exposer.value()->show(feed.frame());
  const std::string served = test::http_get(address.port, "/metrics");
  for (const char* line : {"# HELP farrier_robot_mode 1 for the mode", "# TYPE farrier_joint_redesigns_total counter\n",
                           "\nfarrier_robot_mode{mode=\"armed\"} 1\n",
                           "\nfarrier_joint_missed_ticks_total{leg=\"lf\",joint=\"lf_haa\"} 0\n"}) {
    EXPECT_NE(served.find(line), std::string::npos) << line << "\n" << served;
  }
}

TEST(PrometheusExposer, SaysWhyItCannotListen) {
  const ListenAddress address{"127.0.0.1", test::free_port(), false};
  const auto first = expose_to_prometheus(address, hyq());
  ASSERT_TRUE(first.ok()) << first.error().message;
  const auto second = expose_to_prometheus(address, hyq());
  ASSERT_FALSE(second.ok());
  EXPECT_EQ(second.error().message, "cannot listen on " + address.text() + ": Address already in use");
  const auto elsewhere = expose_to_prometheus({"192.0.2.1", address.port, false}, hyq());
  ASSERT_FALSE(elsewhere.ok());
  EXPECT_NE(elsewhere.error().message.find("Cannot assign requested address"), std::string::npos);
}

}  // namespace metrics_test
}  // namespace farrier::display
