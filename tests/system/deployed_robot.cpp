#include "deployed_robot.hpp"

#include <csignal>
#include <thread>

#include "tools/deploy/deployed_processes.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kRobotFile = FARRIER_ROBOTS "/hyq.yaml";

}  // namespace

robot::Robot deployed_robot(const DeployedRun& run) {
  auto loaded = robot::load_robot(kRobotFile);
  EXPECT_TRUE(loaded.ok()) << (loaded ? "" : config::to_string(loaded.error()));
  robot::Robot robot = std::move(loaded).value();
  robot.file.deployment->clock =
      run.clock == bus::ClockKind::kLockstep ? robot::DeployedClock::kLockstep : robot::DeployedClock::kRealtime;
  for (auto& [name, host] : robot.file.deployment->hosts) {
    if (run.dds != "mixed") {
      host.vendor = run.dds == "fast" ? robot::DdsVendor::kFast : robot::DdsVendor::kCyclone;
    }
  }
  return robot;
}

NetworkNamespaces network_of(const robot::Robot& robot) {
  std::vector<NetworkNamespaces::Host> hosts;
  for (const auto& [name, host] : robot.file.deployment->hosts) {
    hosts.push_back({name, host.interface, host.address});
  }
  return NetworkNamespaces(hosts);
}

DeployedProcesses::DeployedProcesses(const robot::Robot& robot, const NetworkNamespaces& network,
                                     const DeployedRun& run) {
  const deploy::Places places{.prefix = FARRIER_PREFIX, .folder = FARRIER_ROBOTS};
  for (const auto& [host, section] : robot.file.deployment->hosts) {
    const auto processes = deploy::processes_of(robot, host, places);
    if (!processes) {
      ADD_FAILURE() << processes.error().message;
      return;
    }
    for (const deploy::DeployedProcess& process : processes.value()) {
      participant::ProcessOptions options = process.options;
      options.ticks = run.ticks;
      options.slow = run.slow;
      if (process.section.program == robot::Program::kSimBridge) {
        options.trace_path = trace_path();
      }
      running_.push_back({options.name, std::make_unique<FarrierCommand>(
                                            participant::to_arguments(options),
                                            Surroundings{places.executable(process.section.program), network.at(host)})});
    }
  }
}

std::string DeployedProcesses::wait_for_trace(std::size_t bytes, std::chrono::seconds budget) const {
  const auto until = Clock::now() + budget;
  while (Clock::now() < until) {
    std::error_code none;
    const auto size = std::filesystem::file_size(trace_path(), none);
    if (!none && size >= bytes) {
      return {};
    }
    std::this_thread::sleep_for(20ms);
  }
  return "no whole trace within " + std::to_string(budget.count()) + " s:\n" + output();
}

std::string DeployedProcesses::stop() {
  std::string hard_ends;
  for (const Running& running : running_) {
    running.command->signal(SIGTERM);
  }
  for (const Running& running : running_) {
    if (const int status = running.command->wait(10s); status != 0) {
      hard_ends += running.name + " ended with " + std::to_string(status) + ": " + running.command->output() + "\n";
    }
  }
  return hard_ends;
}

std::string DeployedProcesses::output() const {
  std::string all;
  for (const Running& running : running_) {
    all += running.name + ": " + running.command->output() + "\n";
  }
  return all;
}

const FarrierCommand& DeployedProcesses::process(const std::string& name) const {
  return *std::ranges::find(running_, name, &Running::name)->command;
}

}  // namespace farrier::test
