#pragma once

// The processes that a run over DDS starts, watches and buries.

#include <string>
#include <vector>

#include "tools/cli/child_process.hpp"
#include "tools/cli/dds_run.hpp"

namespace farrier::cli {

/// Starts the process of a member; `name` is the child's, its log is `log_name`.log.
Result<ChildProcess> start_child(const DdsRun& run, const participant::ProcessOptions& common,
                                 const lab::Member& member, const std::string& name, const std::string& log_name);

/// Those of all members that have a process of their own.
Result<std::vector<ChildProcess>> start_children(const DdsRun& run, const participant::ProcessOptions& common,
                                                 const std::vector<lab::Member>& members);

/// Takes the dead out of `children`. Refuses when the run cannot do without one: in real time, once it has begun, it
/// can without estimator and supervisors, or without any but sim_bridge if `run` says so; in lock-step everybody waits for everybody.
Result<Done> bury(std::vector<ChildProcess>& children, const DdsRun& run, const std::vector<lab::Member>& members,
                  Tick tick, std::vector<std::string>& warnings);

/// Processes of the members, in their order; 0 for one without.
std::vector<pid_t> pids_of(const std::vector<lab::Member>& members, const std::vector<ChildProcess>& children);

}  // namespace farrier::cli
