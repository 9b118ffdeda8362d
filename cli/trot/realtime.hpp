#pragma once

#include "bench/bare_exchange/bare_realtime.hpp"
#include "cli/processes/dds_run.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/figures/outcome.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::cli {

/// Baseline of this computer on the real-time clock, measured alone. It is a timer loop, and the samples of a run with
/// nothing computed from them, between as many processes over the same vendors.
struct Yardstick {
  bench::TimerLoop timer;
  RunOutcome exchange;
};

/// Measures it, with a bar. Refuses as run_over_dds does.
Result<Yardstick> measure_yardstick(const robot::Robot& robot, const TrotOptions& options);

/// Adds the figures of the baseline, and the ratios to it of a run that left `outcome` and `tracking`. Warns if the
/// baseline itself is beyond a bound. Makes a lock-step run of the same gait with the same loop delay, in process.
/// Refuses if that run does.
Result<Done> add_realtime(report::Outcome& outcome, const robot::Robot& robot, const TrotOptions& options,
                          const Yardstick& yardstick, const report::Tracking& tracking);

}  // namespace farrier::cli
