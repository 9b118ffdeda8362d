#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/visitor.hpp"
#include "core/choice.hpp"
#include "core/processes.hpp"
#include "core/transport.hpp"

namespace farrier::robot {

using farrier::Program;
using farrier::to_string;

/// The bench load that the supervisor designs the published gains for: one load for both slots of a joint, or each slot
/// its own. With kAdaptive both slots begin with the swing load, and each is redesigned when its estimate justifies it.
/// Physics for flow_inversion begin with each phase's own load, as the estimator does.
enum class Design { kStance, kSwing, kPhases, kAdaptive };
/// Names of designs, as robot files and command lines have them.
inline constexpr std::array kDesigns = {
    Option<Design>{"stance", Design::kStance}, Option<Design>{"swing", Design::kSwing},
    Option<Design>{"phases", Design::kPhases}, Option<Design>{"adaptive", Design::kAdaptive}};

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
  Vendor vendor = Vendor::kCyclone;
  int priority_shift = 0;  ///< on every real-time priority
  config::Named<DeployedProcess> processes;
  config::Place place;
};

/// Distribution of a robot's processes over its computers.
struct Deployment {
  int domain = 0;
  int session = 1;
  ClockKind clock = ClockKind::kRealtime;
  Design design = Design::kPhases;
  double watchdog_s = 1.0;
  config::Named<Host> hosts;
  config::Place place;
};

void declare(config::Visitor& v, DeployedProcess& process);
void declare(config::Visitor& v, Host& host);
void declare(config::Visitor& v, Deployment& deployment);

}  // namespace farrier::robot
