#include "cli/trot/trot_run.hpp"

#include <unistd.h>

#include <filesystem>

#include "cli/trot/in_process.hpp"
#include "cli/base/installation.hpp"
#include "report/figures/recording_facts.hpp"

namespace farrier::cli {

participant::ProcessOptions common_options(const TrotOptions& o) {
  participant::ProcessOptions common;
  common.robot_path = o.robot_path;
  common.clock = o.clock;
  common.security = o.security;
  common.seed = o.seed;
  common.session = static_cast<std::uint64_t>(::getpid());
  common.trace_path = o.trace_path;
  common.gait = o.gait;
  common.frequency_Hz = o.frequency_Hz;
  common.design = name_of(robot::kDesigns, o.design.value());
  common.estimator = o.estimator;
  common.controller = o.controller;
  common.world = o.world;
  common.scene_path = o.scene_path;
  common.velocity = o.velocity;
  common.no_dither = o.design != robot::Design::kAdaptive;
  return common;
}

mcap::Text record_facts(const robot::Robot& robot, const TrotOptions& o) {
  mcap::Text facts = report::recording_facts(robot);
  facts["seed"] = std::to_string(o.seed);
  facts["clock"] = name_of(kClockKinds, o.clock);
  facts["design"] = name_of(robot::kDesigns, o.design.value());
  facts["vendor"] = to_string(o.dds);
  return facts;
}

DdsRun dds_run(const robot::Robot& robot, const TrotOptions& o, const std::string& title) {
  DdsRun run;
  run.dds = o.dds;
  run.grouping = grouping_of(o);
  run.common = common_options(o);
  run.common.ticks = run::ticks_of(o.duration_s, robot);
  run.executables = processes_directory();
  run.locomotion = o.locomotion.empty() ? "" : std::filesystem::absolute(o.locomotion).string();
  run.no_locomotion = o.no_locomotion;
  run.log_directory = o.out + "/log";
  run.record_path = o.record_path;
  run.record_facts = record_facts(robot, o);
  run.title = title;
  run.standby = o.standby;
  run.start_limit_s = o.start_limit_s;
  run.stall_limit_s = o.stall_limit_s;
  run.soak = o.soak;
  return run;
}

Result<RunOutcome> run_once(const robot::Robot& robot, const TrotOptions& o, const std::string& title,
                            const World& world) {
  if (o.dds == DdsChoice::kInproc) {
    return run_in_process(robot, o, o.design.value(), o.trace_path, title,
                          {.world = world.robot, .record_path = o.record_path});
  }
  DdsRun run = dds_run(robot, o, title);
  run.common.simulated_path = world.path;
  return run_over_dds(robot, run);
}

}  // namespace farrier::cli
