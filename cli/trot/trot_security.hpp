#pragma once

#include "cli/trot/trot_options.hpp"
#include "report/figures/figures.hpp"

namespace farrier::cli {

/// Refuses a `--security` that a process of the run would refuse, before any of them starts. Also refuses it for runs
/// in process, which it does not reach.
Result<Done> check_security(const robot::Robot& robot, const TrotOptions& options);

/// Adds trot.security.latency_p50_ratio: short runs of the same processes, alternately with and without security.
/// Refuses if run_over_dds does, and if no valve command came back in a run.
Result<Done> add_security_cost(const robot::Robot& robot, const TrotOptions& options, report::Figures& figures);

}  // namespace farrier::cli
