#pragma once

#include <string>

#include "cli/processes/dds_run.hpp"
#include "cli/trot/trot_options.hpp"

namespace farrier::cli {

/// Options of the command line that go to every process.
participant::ProcessOptions common_options(const TrotOptions& options);

/// Facts of a run in its recording, besides samples.
mcap::Text record_facts(const robot::Robot& robot, const TrotOptions& options);

/// A run over DDS as the options say, with a bar called `title`.
DdsRun dds_run(const robot::Robot& robot, const TrotOptions& options, const std::string& title);

/// A robot that is simulated in place of the one that all other processes know, and its file, which only sim_bridge
/// reads.
struct World {
  const robot::Robot* robot = nullptr;  ///< null: the robot that all processes know
  std::string path;
};

/// One run of the gait as the options say, over DDS or in process, with a bar called `title`: trace and recording.
/// Refuses if run_over_dds or run_in_process does.
Result<RunOutcome> run_once(const robot::Robot& robot, const TrotOptions& options, const std::string& title,
                            const World& world = {});

}  // namespace farrier::cli
