#pragma once

#include <string>

#include "cli/processes/dds_run.hpp"
#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// What the command line says to every process.
participant::ProcessOptions common_options(const TrotOptions& options);

/// What a recording of a run says of it besides samples.
mcap::Text record_facts(const robot::Robot& robot, const TrotOptions& options);

/// A run over DDS as the options say, with a bar called `title`.
DdsRun dds_run(const robot::Robot& robot, const TrotOptions& options, const std::string& title);

/// A robot that is simulated in place of the one everybody else knows, and its robot file, which only sim_bridge reads.
struct World {
  const robot::Robot* robot = nullptr;  ///< null: the robot that everybody knows
  std::string path;
};

/// One run of the gait as the options say, over DDS or in process, with a bar called `title`: trace and recording.
/// Refuses what run_over_dds and run_in_process do.
Result<RunOutcome> run_once(const robot::Robot& robot, const TrotOptions& options, const std::string& title,
                            const World& world = {});

}  // namespace farrier::cli
