#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/visitor.hpp"

namespace farrier::robot {

/// Which executable a process is.
enum class Program { kSimBridge, kEstimatorService, kSupervisor, kGaitSource, kJointNode };

/// Name of the executable: "joint_node".
const char* to_string(Program program) noexcept;

/// DDS vendors a host's processes may run on.
enum class DdsVendor { kCyclone, kFast };
enum class DeployedClock { kLockstep, kRealtime };
/// What the supervisor's gains are for.
enum class Design { kStance, kSwing, kPhases, kAdaptive };
/// As on a command line: "phases".
const char* to_string(Design design) noexcept;

/// One process of a host.
struct DeployedProcess {
  Program program = Program::kJointNode;
  std::vector<std::string> joints;  ///< joint_node: those it hosts; empty for others
  std::vector<int> cpus;            ///< it may run on; empty: all
  int memory_max_MB = 512;
  config::Place place;
};

/// One computer of a robot.
struct Host {
  std::string address;    ///< IPv4, of the interface
  std::string interface;  ///< the one DDS uses
  DdsVendor vendor = DdsVendor::kCyclone;
  int priority_shift = 0;  ///< on every real-time priority
  config::Named<DeployedProcess> processes;
  config::Place place;
};

/// How a robot's processes are spread over its computers.
struct Deployment {
  int domain = 0;
  int session = 1;
  DeployedClock clock = DeployedClock::kRealtime;
  Design design = Design::kPhases;
  double watchdog_s = 1.0;
  config::Named<Host> hosts;
  config::Place place;
};

void declare(config::Visitor& v, DeployedProcess& process);
void declare(config::Visitor& v, Host& host);
void declare(config::Visitor& v, Deployment& deployment);

}  // namespace farrier::robot
