#pragma once

#include <functional>
#include <string>
#include <vector>

#include "locomotion/controller.hpp"
#include "locomotion/gait_source.hpp"
#include "participant/options.hpp"
#include "run/run_plan.hpp"
#include "mcap/records.hpp"
#include "robot/load_change.hpp"
#include "sim_bridge/sim_bridge_lockstep.hpp"
#include "supervisor/supervisor.hpp"

namespace farrier::run {

/// A whole run in one thread over the in-process bus: the same node cores, ports and lock-step as over DDS.
struct InprocRun {
  Grouping grouping = Grouping::kPerLeg;
  Tick ticks = 0;
  std::uint64_t seed = 1;
  supervisor::Design design = supervisor::Design::kStance;
  std::vector<robot::LoadChange> load_changes;     ///< of the simulated world
  std::vector<robot::LoadChange> known_loads;      ///< load changes that the supervisor knows and designs for exactly
  std::vector<supervisor::SlotGains> first_gains;  ///< by joint: the supervisor's first; empty: as `design` says
  locomotion::Announce announce = locomotion::Announce::kPlanned;  ///< what locomotion says of touchdowns
  const robot::Robot* simulated = nullptr;                         ///< what sim_bridge simulates; null: the robot
  participant::World world = participant::World::kBench;
  std::string scene_path;                  ///< scene file of a body; empty: a plane
  std::vector<double> velocity;            ///< as ProcessOptions has it
  const robot::Robot* designer = nullptr;  ///< what the supervisor designs for; null: the robot
  std::string trace_path;                  ///< empty: none
  std::string record_path;                 ///< a recording of everything goes there; empty: none
  mcap::Text record_facts;                 ///< recording::kRunFacts of it
  sim_bridge::RowSink sink;                ///< gets every row a trace would hold; empty: none
  std::function<void(const signals::JointModelEstimate&)> estimates;  ///< gets every estimate; empty: none
  std::function<bool(Tick)> progress;                                 ///< called now and then; false ends the run early
};

struct InprocResult {
  std::vector<signals::SystemHello> hellos;  ///< by participant
  std::vector<signals::SystemHealth> healths;
  std::vector<signals::SystemEvent> events;
  std::vector<signals::JointUpdateDecision> decisions;
  std::vector<signals::JointControllerGains> gains;  ///< every update the supervisor issued, in order
  std::vector<signals::GaitPhase> phases;            ///< changes of phase that joints were told, in order
};

/// `robot` is the model that every participant has; `simulated` and `designer` differ from it in values only, never in
/// joints and legs. Refuses with the reason, also when the run does not advance (a bug: nothing outside can block it).
Result<InprocResult> run_inproc(const robot::Robot& robot, const InprocRun& run);

}  // namespace farrier::run
