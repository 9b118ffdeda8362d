#pragma once

#include <vector>

#include "run/inproc_run.hpp"
#include "trace/trace.hpp"
#include "trials/load_cycle.hpp"
#include "cli/compare/compare_options.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {

/// farrier compare switching: what changing gains with the phase is worth right after touchdown. An adaptive
/// run of the gait gives every joint its gains of both phases; then nothing is redesigned and nothing dithers. "On":
/// each phase acts with its own, switched as the product does it: touchdowns are announced as planned, and stance gains
/// act stance_lead_s earlier. "Off": the swing gains act in both phases, for they act when a leg lands, and estimates
/// alone would tell of it only later. Both again against the stance gains in both phases. Twice: with a reference and a
/// weight that step at touchdown, and with the load transfer of the robot file.
int run_switching(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare update-logic: the four update logics of Hubacher (2014), Section 5.3.1, each with the
/// parameters of its robot file, on the load cycle of the shipped rig and on an adaptive trot of `robot`.
int run_update_logic(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare controllers: one linear design, feedback linearisation, PID, adaptive linear gains and the
/// grey box with flow inversion, on varied robots and on the load cycle of the shipped rig; `options.seeds` of
/// each.
int run_controllers(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare varied: robots drawn unlike their file, under adaptation, perfect knowledge and fixed controllers.
int run_varied(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare noise: the load cycle of the shipped rig and the robots of compare varied with sensors from none of
/// their noise to three times as much. Better sensors must not make adaptation worse.
int run_noise(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare models: the linear model of the shipped rig in three forms: exact, the thesis's, and with a piston
/// without mass. For some loads, each form's resonance, the gains designed on it and their margin on the exact one.
int run_models(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare bandwidth: frequencies of -3 dB and of -90 degrees of the force of each joint of a leg. The joint is held
/// in three poses and follows sines of three amplitudes, with the file's valve and with valves of report::kBandwidthDesigns.
int run_bandwidth(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare filters: disk margins of the rig's and the robot's designs behind sensors that filter, and margins
/// behind drawn filters against the loop that runs.
int run_filters(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare friction: every kind of controller on the load cycle of the shipped rig and on the gait of `robot`.
/// Contacts on either side of the load cell stick, sensors filter. A run either holds or is refused before it begins.
int run_friction(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare body: the force controllers of trials::force_controllers on a ground, `options.seeds` runs each of a
/// walk and of a step, and what limits the robot file's own. A build without MuJoCo refuses (without_body.cpp).
int run_body(const robot::Robot& robot, const CompareOptions& options);

/// farrier compare adaptation: plants that no design knows, on grounds and gaits of trials::kStudyConditions, for the
/// designs of trials::study_designs; with `options.search` the search for a fixed design. It prints each row as it ends.
/// A build without MuJoCo refuses (without_body.cpp).
int run_adaptation(const robot::Robot& robot, const CompareOptions& options);

/// Larger relative force error of the two heavy and of the two light quarters of trials::LoadCycle.
struct CycleErrors {
  double heavy = 0.0, light = 0.0;
};

/// Runs `believed` through the cycle. Refuses what run::run_inproc does, and when the user interrupts.
Result<CycleErrors> run_load_cycle(const trials::LoadCycle& cycle, const robot::Robot& believed, run::InprocRun run);

/// A run in process and the rows of its trace.
struct ComparedRun {
  std::vector<trace::TraceRow> rows;
  run::InprocResult result;
};

/// Runs with a bar called `title`; the trace goes to `trace_path`. Refuses what run::run_inproc does, and when the user
/// interrupts.
Result<ComparedRun> run_compared(const robot::Robot& robot, run::InprocRun run, const std::string& trace_path,
                                 const std::string& title);

/// Adds the run's errors to the failures.
void add_failures(report::Outcome& outcome, const ComparedRun& run, const std::string& title);

/// Writes the figures, prints them, names the files; gives the exit status.
int finish_comparison(const report::Outcome& outcome, const CompareOptions& options, const std::string& page);

}  // namespace farrier::cli
