#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/visitor.hpp"
#include "core/result.hpp"

namespace farrier::robot {

/// Which executable a process is.
enum class Program { kSimBridge, kEstimatorService, kSupervisor, kGaitSource, kJointNode };

/// Name of the executable: "joint_node".
const char* to_string(Program program) noexcept;

/// DDS vendors a host's processes may run on.
enum class DdsVendor { kCyclone, kFast };
enum class DeployedClock { kLockstep, kRealtime };
/// The bench load that the supervisor designs the published gains for: one load for both slots of a joint, or each slot
/// its own. kAdaptive begins with the swing load in both slots and redesigns each when its estimate says that it pays;
/// physics for flow_inversion begin with each phase's own load, as the estimator does.
enum class Design { kStance, kSwing, kPhases, kAdaptive };
/// Names of designs, as robot files and command lines have them.
inline constexpr std::array kDesigns = {
    config::Option<Design>{"stance", Design::kStance}, config::Option<Design>{"swing", Design::kSwing},
    config::Option<Design>{"phases", Design::kPhases}, config::Option<Design>{"adaptive", Design::kAdaptive}};
const char* to_string(Design design) noexcept;
/// Refuses a name that kDesigns does not have.
Result<Design> parse_design(std::string_view name);

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
