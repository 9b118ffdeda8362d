#pragma once

#include <string>
#include <vector>

#include "supervisor/supervisor.hpp"
#include "cli/trot/trot_options.hpp"
#include "report/trot/tracking.hpp"

namespace farrier::cli {

/// Options of a run beyond those of TrotOptions.
struct Extras {
  const robot::Robot* world = nullptr;  ///< what sim_bridge simulates; null: the robot
  std::string record_path;              ///< a recording of everything goes there; empty: none
};

/// A trot in this process, in lock-step, with a bar called `title`; the trace goes to `trace_path`. Refuses if
/// run::run_inproc does, and when the user interrupts.
Result<RunOutcome> run_in_process(const robot::Robot& robot, const TrotOptions& options, supervisor::Design design,
                                  const std::string& trace_path, const std::string& title, const Extras& extras = {});

/// The same robot without dither, for runs with fixed gains.
robot::Robot without_dither(robot::Robot robot);

/// Returns the tracking of the joints in this run. The rows of a run over DDS are read from its trace first; refuses a
/// trace that cannot be read.
Result<report::Tracking> tracking_of(const robot::Robot& robot, RunOutcome& run, const std::string& trace_path,
                                     std::uint64_t seed, int loop_delay_ticks);

/// Adds the tracking of the same gait with the swing design in both slots. In process: lock-step traces do not depend
/// on the transport.
Result<Done> add_swing_design(const robot::Robot& robot, const TrotOptions& options, report::Figures& figures);

/// Adds trot.dither_cost_ratio: two runs of the gait with each phase's own fixed design, with the dither of `robot` and
/// without.
Result<Done> add_dither_cost(const robot::Robot& robot, const TrotOptions& options, report::Figures& figures);

}  // namespace farrier::cli
