#include "tools/report/run_info.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "bus/bus.hpp"
#include "bus/topics.hpp"

namespace farrier::report {
namespace {

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
                      .missed_deadlines = health.missed_deadlines,
                      .latency_p50_s = health.latency_p50_s,
                      .latency_p99_s = health.latency_p99_s,
                      .topics = {}};
  for (const bus::TopicSpec& topic : bus::topics()) {
    const auto i = static_cast<std::size_t>(topic.id);
    if (health.sent[i] + health.received[i] + health.lost[i] > 0) {
      process.topics.push_back({topic.name, health.sent[i], health.received[i], health.lost[i]});
    }
  }
  return process;
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
  const auto measured =
      std::ranges::find_if(run.processes, [](const ProcessInfo& process) { return process.latency_p99_s > 0.0; });
  if (measured != run.processes.end()) {
    figures.add("trot.latency_p50_us", measured->latency_p50_s * 1e6);
    figures.add("trot.latency_p99_us", measured->latency_p99_s * 1e6);
  }
}

}  // namespace farrier::report
