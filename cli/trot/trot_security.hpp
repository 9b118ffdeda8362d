#pragma once

#include "cli/trot/trot_options.hpp"
#include "report/figures/figures.hpp"

namespace farrier::cli {

/// Refuses what every process of the run would refuse of `--security`, before any of them starts; and runs that it does
/// not reach, because they are in process.
Result<Done> check_security(const robot::Robot& robot, const TrotOptions& options);

/// Adds trot.security.latency_p50_ratio: short runs of the same processes with security and without, in turns. Refuses
/// what run_over_dds does, and runs in which no valve command came back.
Result<Done> add_security_cost(const robot::Robot& robot, const TrotOptions& options, report::Figures& figures);

}  // namespace farrier::cli
