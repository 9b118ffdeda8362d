#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "run/run_listener.hpp"
#include "cli/processes/child_process.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/processes/host_clock.hpp"

// The processes that a run consists of besides this one.

namespace farrier::cli {

/// Starts a member of the run. `name`: of this start in the list of children; `log_name`: of its log. `clock`: the wall
/// clock it sees; null: the computer's.
Result<ChildProcess> start_child(const DdsRun& run, const participant::ProcessOptions& common,
                                 const run::Member& member, const std::string& name, const std::string& log_name,
                                 const HostClock* clock);

Result<std::vector<ChildProcess>> start_children(const DdsRun& run, const participant::ProcessOptions& common,
                                                 const std::vector<run::Member>& members, const HostClock* clock);

inline constexpr std::chrono::seconds kSilenceWorthSaying{3};

/// Starts a process that listens to all streams of the run and logs those of `joint`, of the joint nodes' vendor.
Result<ChildProcess> start_monitor(const DdsRun& run, const participant::ProcessOptions& common,
                                   const std::string& name, const std::string& joint);

/// Starts `farrier record` for the whole run, so that a process without part in control records it. Also refuses if its
/// file cannot be written.
Result<ChildProcess> start_recorder(const robot::Robot& robot, const DdsRun& run,
                                    const participant::ProcessOptions& common);

/// Reason why nothing moves: the stopped processes, or else the input that sim_bridge waits for, or else this process.
std::string standstill(const run::RunListener& listener, const std::vector<ChildProcess>& children);

/// Removes processes that have ended from `children`. Refuses if the run cannot do without one. In real time, once it
/// has begun, it can do without estimator, supervisors and recorder, or without any if `run` says so. In lock-step it
/// needs all.
Result<Done> bury(std::vector<ChildProcess>& children, const DdsRun& run, const std::vector<run::Member>& members,
                  Tick tick, std::vector<std::string>& warnings);

/// Processes of the members, in their order; 0 for one without.
std::vector<pid_t> pids_of(const std::vector<run::Member>& members, const std::vector<ChildProcess>& children);

}  // namespace farrier::cli
