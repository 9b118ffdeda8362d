#pragma once

#include "bench/bare_exchange/bare_realtime.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/figures/outcome.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::cli {

/// What this computer allows on the real-time clock, measured alone: a timer loop, and the samples of a run with nothing
/// computed from them, between as many processes over the same vendors.
struct Yardstick {
  bench::TimerLoop timer;
  RunOutcome exchange;
};

/// Measures it, with a bar. Refuses as run_over_dds does.
Result<Yardstick> measure_yardstick(const robot::Robot& robot, const TrotOptions& options);

/// Adds the figures of the yardstick and what a run that left `outcome` and `tracking` is beside it, with a warning where
/// the yardstick itself is beyond a bound; makes a lock-step run of the same gait with the same loop delay, in process.
/// Refuses what that run does.
Result<Done> add_realtime(report::Outcome& outcome, const robot::Robot& robot, const TrotOptions& options,
                          const Yardstick& yardstick, const report::Tracking& tracking);

}  // namespace farrier::cli
