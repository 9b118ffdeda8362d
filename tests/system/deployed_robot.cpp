#include "deployed_robot.hpp"

#include <algorithm>
#include <csignal>
#include <map>
#include <sstream>
#include <thread>

#include "tools/deploy/rendering.hpp"

namespace farrier::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kRobotFile = FARRIER_ROBOTS "/hyq.yaml";
const deploy::Places kPlaces{.prefix = FARRIER_PREFIX, .folder = FARRIER_ROBOTS};

/// "name = value" of the rendered sysctl file, those that every network namespace has its own of.
std::map<std::string, std::string> network_settings(const robot::Robot& robot, const std::string& host) {
  std::map<std::string, std::string> settings;
  const auto files = deploy::render_host(robot, "", host, kPlaces);
  for (const deploy::RenderedFile& file : files.value()) {
    std::istringstream text(file.name.ends_with(".conf") ? file.text : "");
    for (std::string line; std::getline(text, line);) {
      if (const auto equals = line.find(" = "); line.starts_with("net/ipv4/")) {
        settings[line.substr(0, equals)] = line.substr(equals + 3);
      }
    }
  }
  return settings;
}

}  // namespace

robot::Robot deployed_robot(const DeployedRun& run) {
  auto loaded = robot::load_robot(kRobotFile);
  EXPECT_TRUE(loaded.ok()) << (loaded ? "" : config::to_string(loaded.error()));
  robot::Robot robot = std::move(loaded).value();
  robot.file.deployment->clock =
      run.clock;
  for (auto& [name, host] : robot.file.deployment->hosts) {
    if (run.dds != "mixed") {
      host.vendor = run.dds == "fast" ? Vendor::kFast : Vendor::kCyclone;
    }
  }
  return robot;
}

NetworkNamespaces network_of(const robot::Robot& robot) {
  std::vector<NetworkNamespaces::Host> hosts;
  for (const auto& [name, host] : robot.file.deployment->hosts) {
    hosts.push_back({name, host.interface, host.address});
  }
  NetworkNamespaces network(hosts);
  for (const NetworkNamespaces::Host& host : hosts) {
    for (const auto& [name, value] : network_settings(robot, host.name)) {
      network.set(host.name, name, value);
    }
  }
  return network;
}

DeployedProcesses::DeployedProcesses(const robot::Robot& robot, const NetworkNamespaces& network,
                                     const DeployedRun& run) {
  for (const auto& [host, section] : robot.file.deployment->hosts) {
    const auto processes = deploy::processes_of(robot, host, kPlaces);
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
      const Surroundings surroundings{kPlaces.executable(process.section.program), network.at(host)};
      running_.push_back({options, std::make_unique<FarrierCommand>(participant::to_arguments(options), surroundings)});
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
      hard_ends += running.options.name + " ended with " + std::to_string(status) + ": " + running.command->output() + "\n";
    }
  }
  return hard_ends;
}

std::string DeployedProcesses::output() const {
  std::string all;
  for (const Running& running : running_) {
    all += running.options.name + ": " + running.command->output() + "\n";
  }
  return all;
}

const participant::ProcessOptions& DeployedProcesses::options_of(const std::string& name) const {
  return std::ranges::find(running_, name, [](const Running& running) { return running.options.name; })->options;
}

}  // namespace farrier::test
