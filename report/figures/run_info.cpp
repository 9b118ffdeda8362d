#include "report/figures/run_info.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "bus/bus.hpp"
#include "bus/topics.hpp"

namespace farrier::report {
namespace {

/// Share of a control loop's periods that a computer which keeps up may miss.
constexpr double kMissedPeriods = 0.005;

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos && (line.starts_with("model name") || line.starts_with("Model"))) {
      return line.substr(colon + 2);
    }
  }
  return "unknown";
}

Machine this_machine() {
  utsname system{};
  ::uname(&system);
  return {.cpu_model = cpu_model(),
          .cores = static_cast<int>(::sysconf(_SC_NPROCESSORS_ONLN)),
          .kernel = std::string(system.sysname) + " " + system.release + " " + system.version,
          .memory_bytes = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                          static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE))};
}

std::string vendor_name(std::uint8_t number) {
  const auto vendor = static_cast<bus::Vendor>(number);
  switch (vendor) {
    case bus::Vendor::kInproc:
    case bus::Vendor::kCyclone:
    case bus::Vendor::kFast: return bus::to_string(vendor);
  }
  return "unknown vendor " + std::to_string(number);
}

std::string part_of_a_name(std::string text) {
  std::ranges::replace(text, '/', '_');
  std::ranges::replace(text, '.', '_');
  return text;
}

}  // namespace

std::string build_name() { return FARRIER_VERSION " (git " FARRIER_GIT_REVISION ")"; }

RunInfo run_info(std::uint64_t seed) {
  RunInfo run;
  run.version = FARRIER_VERSION;
  run.git_revision = FARRIER_GIT_REVISION;
  run.seed = seed;
  run.machine = this_machine();
  return run;
}

RunInfo run_info(const robot::Robot& robot, std::uint64_t seed) {
  RunInfo run = run_info(seed);
  run.configuration = robot::print_config(robot);
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(robot::configuration_hash(robot)));
  run.configuration_hash = hash;
  return run;
}

std::vector<DecisionInfo> decision_infos(const robot::Robot& robot,
                                         std::span<const signals::JointUpdateDecision> decisions) {
  std::vector<DecisionInfo> infos;
  for (const signals::JointUpdateDecision& decision : decisions) {
    if (decision.joint < robot.joints.size()) {
      infos.push_back({robot.joints[decision.joint].name, decision});
    }
  }
  return infos;
}

ProcessInfo process_info(const signals::SystemHello& hello, const signals::SystemHealth& health) {
  ProcessInfo process{.name = std::string(signals::text_of(hello.name)),
                      .number = hello.participant,
                      .pid = hello.pid,
                      .vendor = vendor_name(hello.vendor),
                      .periods = health.periods,
                      .missed_periods = health.missed_periods,
                      .latency_s = health.latency_s,
                      .wake_up_s = health.wake_up_s,
                      .topics = {}};
  for (const bus::TopicSpec& topic : bus::topics()) {
    const auto i = static_cast<std::size_t>(topic.id);
    if (health.sent[i] + health.received[i] + health.lost[i] > 0) {
      process.topics.push_back({topic.name, health.sent[i], health.received[i], health.lost[i]});
    }
  }
  return process;
}

std::vector<ProcessInfo> process_infos(const std::vector<signals::SystemHello>& hellos,
                                       const std::vector<signals::SystemHealth>& healths) {
  std::vector<ProcessInfo> processes;
  for (std::size_t i = 0; i < hellos.size(); ++i) {
    processes.push_back(process_info(hellos[i], healths[i]));
  }
  return processes;
}

void add_transport(Figures& figures, const RunInfo& run, bool judge_losses) {
  std::uint64_t lost = 0;
  for (const ProcessInfo& process : run.processes) {
    for (const TopicCount& topic : process.topics) {
      const std::string name = "trot.packets." + part_of_a_name(process.name) + "." + part_of_a_name(topic.topic);
      if (topic.sent > 0) {
        figures.add(name + ".sent", static_cast<double>(topic.sent));
      }
      if (topic.received > 0) {
        figures.add(name + ".received", static_cast<double>(topic.received));
      }
      lost += topic.lost;
    }
  }
  figures.add("trot.lost_samples", static_cast<double>(lost), judge_losses ? std::optional(0.0) : std::nullopt);
  add_latencies(figures, "trot", run.processes, kMissedPeriods);
}

void add_latencies(Figures& figures, const std::string& prefix, const std::vector<ProcessInfo>& processes,
                   std::optional<double> missed_bound) {
  constexpr std::array kNames{"p50", "p99", "p999", "max"};
  std::uint64_t periods = 0;
  std::uint64_t missed = 0;
  for (const ProcessInfo& process : processes) {
    periods += process.periods;
    missed += process.periods > 0 ? process.missed_periods : 0;
    for (std::size_t i = 0; i < kNames.size() && process.latency_s.back() > 0.0; ++i) {
      figures.add(prefix + ".latency_" + kNames[i] + "_us", process.latency_s[i] * 1e6);
    }
    for (std::size_t i = 0; i < kNames.size() && process.wake_up_s.back() > 0.0; ++i) {
      figures.add(prefix + ".wake_up_" + kNames[i] + "_us", process.wake_up_s[i] * 1e6);
    }
  }
  if (periods > 0) {
    figures.add(prefix + ".missed_periods", static_cast<double>(missed) / static_cast<double>(periods + missed),
                missed_bound);
  }
}

}  // namespace farrier::report
