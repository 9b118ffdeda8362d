#pragma once

// The robot of deploy/robots/hyq.yaml as it is deployed: its processes on the hosts of that file, each a network
// namespace with the host's address, with the command lines of the units that farrier deploy renders.

#include <memory>
#include <string>
#include <vector>

#include "farrier_command.hpp"
#include "participant/options.hpp"
#include "robot/robot.hpp"
#include "tests/support/network_namespaces.hpp"

namespace farrier::test {

/// Settings of a run besides the deployment.
struct DeployedRun {
  std::string dds;  ///< "cyclone" or "fast" on every host, "mixed": as the file says
  bus::ClockKind clock = bus::ClockKind::kLockstep;
  Tick ticks = 0;   ///< 0: until it is stopped
  int slow = 1;     ///< slow motion, real time only
};

/// hyq.yaml with the vendors of `run`.
robot::Robot deployed_robot(const DeployedRun& run);

/// A computer for every host of its deployment, its network set as the rendered files say.
NetworkNamespaces network_of(const robot::Robot& robot);

/// The processes of every host, running.
class DeployedProcesses {
 public:
  DeployedProcesses(const robot::Robot& robot, const NetworkNamespaces& network, const DeployedRun& run);

  /// Where sim_bridge writes its trace.
  std::string trace_path() const { return scratch_.file("trace.csv"); }
  /// Waits until all are still there and the trace has that size; what is wrong otherwise, with everybody's last words.
  std::string wait_for_trace(std::size_t bytes, std::chrono::seconds budget) const;
  /// Ends all as systemd would; names of those that did not end with status 0.
  std::string stop();
  /// Returns the output of all processes.
  std::string output() const;
  /// Returns the options with which the process of that name was started.
  const participant::ProcessOptions& options_of(const std::string& name) const;

 private:
  struct Running {
    participant::ProcessOptions options;
    std::unique_ptr<FarrierCommand> command;
  };

  ScratchDirectory scratch_;
  std::vector<Running> running_;
};

}  // namespace farrier::test
