#include "cli/processes/run_children.hpp"

#include <algorithm>
#include <optional>

#include "recording/recording_file.hpp"
#include "runtime/processors.hpp"
#include "cli/base/installation.hpp"
#include "core/replace_file.hpp"

namespace farrier::cli {
namespace {

constexpr const char* kRecorder = "record";

/// In real time the processes on the way from sensor to valve have a processor each, as far as there are some. The
/// threads of one process then wake each other on their own processor, without an interrupt from another.
std::optional<int> processor_of(const run::Member& member, bus::ClockKind clock) {
  const bool is_joint_node = !member.joints.empty();
  if (clock != bus::ClockKind::kRealtime || (member.number != participant::kSimBridge && !is_joint_node)) {
    return std::nullopt;
  }
  const std::vector<int> processors = runtime::own_processors();
  const std::size_t place =
      is_joint_node ? static_cast<std::size_t>(member.number - participant::kFirstJointNode + 1) : 0;
  return processors.empty() ? std::nullopt : std::optional(processors[place % processors.size()]);
}

}  // namespace

Result<ChildProcess> start_child(const DdsRun& run, const participant::ProcessOptions& common,
                                 const run::Member& member, const std::string& name, const std::string& log_name,
                                 const HostClock* clock) {
  participant::ProcessOptions options = common;
  options.vendor = vendor_of(run.dds, member);
  options.name = member.name;
  options.number = member.number;
  options.joints = member.joints;
  options.standby = member.stands_by;
  if (member.number != participant::kSimBridge) {
    options.trace_path.clear();
  }
  if (const auto faults = run.faults.find(member.name); faults != run.faults.end()) {
    for (const bus_faults::ArrowFault& fault : faults->second) {
      options.faults.push_back(bus_faults::to_string(fault));
    }
  }
  const std::string program =
      run.bare ? "bare_exchange" : member.executable + (options.faults.empty() ? "" : "_with_faults");
  const bool replaced = member.number == participant::kLocomotion && !run.locomotion.empty() && !run.bare;
  const std::string executable = replaced ? run.locomotion : run.executables + "/" + program;
  return ChildProcess::start(name, executable, participant::to_arguments(options),
                             run.log_directory + "/" + log_name + ".log",
                             {.environment = clock != nullptr ? clock->environment() : std::vector<std::string>{},
                              .processor = processor_of(member, common.clock)});
}

Result<std::vector<ChildProcess>> start_children(const DdsRun& run, const participant::ProcessOptions& common,
                                                 const std::vector<run::Member>& members, const HostClock* clock) {
  std::vector<ChildProcess> children;
  for (const run::Member& member : members) {
    if (member.executable.empty() || (run.no_locomotion && member.number == participant::kLocomotion)) {
      continue;
    }
    children.push_back(FARRIER_TRY(start_child(run, common, member, member.name, member.name, clock)));
  }
  return children;
}

Result<ChildProcess> start_monitor(const DdsRun& run, const participant::ProcessOptions& common,
                                   const std::string& name, const std::string& joint) {
  std::vector<std::string> arguments{"echo"};
  for (const bus::TopicSpec& topic : bus::topics()) {
    if (topic.sending == bus::Sending::kTogether) {
      arguments.emplace_back(topic.name);
    }
  }
  arguments.insert(arguments.end(),
                   {"--joint", joint, "--robot", common.robot_path, "--domain", std::to_string(common.network.domain),
                    "--dds", to_string(run.dds == DdsChoice::kCyclone ? Vendor::kCyclone : Vendor::kFast)});
  return ChildProcess::start(name, farrier_command(), arguments, run.log_directory + "/" + name + ".log");
}

Result<ChildProcess> start_recorder(const robot::Robot& robot, const DdsRun& run,
                                    const participant::ProcessOptions& common) {
  // The robot with the options of this run, which is in no other file.
  const std::string robot_path = run.log_directory + "/" + robot.name + ".yaml";
  FARRIER_TRY(replace_file(robot_path, robot::print_config(robot)));
  std::vector<std::string> arguments{"record",
                                     run.record_path,
                                     "--force",
                                     "--robot",
                                     robot_path,
                                     "--domain",
                                     std::to_string(common.network.domain),
                                     "--dds",
                                     to_string(run.dds == DdsChoice::kFast ? Vendor::kFast : Vendor::kCyclone)};
  if (!common.security.empty()) {
    arguments.insert(arguments.end(), {"--security", common.security});
  }
  for (const auto& [name, value] : run.record_facts) {
    if (value.find('\n') == std::string::npos) {
      arguments.insert(arguments.end(), {"--fact", name + "=" + value});
    }
  }
  return ChildProcess::start(kRecorder, farrier_command(), arguments, run.log_directory + "/" + kRecorder + ".log");
}

std::string standstill(const run::RunListener& listener, const std::vector<ChildProcess>& children) {
  std::string stopped;
  for (const ChildProcess& child : children) {
    if (child.stopped()) {
      stopped += (stopped.empty() ? "" : ", ") + child.name() + " (pid " + std::to_string(child.pid()) + ")";
    }
  }
  if (!stopped.empty()) {
    return "stopped: " + stopped + "; the run stands at tick " + std::to_string(listener.tick());
  }
  const std::string said =
      listener.tick() == 0 || children.empty() ? "" : children.front().last_words(kSilenceWorthSaying);
  return said.empty() ? "waiting for " + listener.waits_for() : said;
}

Result<Done> bury(std::vector<ChildProcess>& children, const DdsRun& run, const std::vector<run::Member>& members,
                  Tick tick, std::vector<std::string>& warnings) {
  const bool realtime = run.common.clock == bus::ClockKind::kRealtime;
  const auto dispensable = [&](const std::string& name) {
    const auto member = std::ranges::find(members, name, &run::Member::name);
    return name == kRecorder || run.goes_on_without_the_dead ||
           (member != members.end() && std::ranges::any_of(kPrograms, [&](const ProgramInfo& program) {
              return program.name == member->executable && !program.needed;
            }));
  };
  for (auto child = children.begin(); child != children.end();) {
    if (child->running()) {
      ++child;
      continue;
    }
    if (!dispensable(child->name()) || !realtime || tick <= 0) {
      return Error{child->epitaph() +
                   (realtime ? "" : "\nIn lock-step every process waits for every other, so the run ends.")};
    }
    warnings.push_back("without " + child->name() + " after tick " + std::to_string(tick) + ": " + child->epitaph() +
                       (child->name() == kRecorder ? recording::left_behind(run.record_path) : ""));
    child = children.erase(child);
  }
  return Done{};
}

std::vector<pid_t> pids_of(const std::vector<run::Member>& members, const std::vector<ChildProcess>& children) {
  std::vector<pid_t> pids;
  for (const run::Member& member : members) {
    const auto child = std::ranges::find(children, member.name, &ChildProcess::name);
    pids.push_back(child == children.end() ? 0 : child->pid());
  }
  return pids;
}

}  // namespace farrier::cli
