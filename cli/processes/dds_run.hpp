#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bus_faults/arrow_fault.hpp"
#include "run/run_plan.hpp"
#include "mcap/records.hpp"
#include "participant/options.hpp"
#include "trace/trace.hpp"
#include "cli/processes/growth_watch.hpp"
#include "cli/processes/onlookers.hpp"
#include "cli/processes/run_acts.hpp"

namespace farrier::cli {

/// Vendors of the processes of a run.
enum class DdsChoice { kCyclone, kFast, kMixed, kInproc };
const char* to_string(DdsChoice choice) noexcept;

bus::Vendor vendor_of(DdsChoice choice, const run::Member& member) noexcept;

/// An operator's action at one moment of a run.
struct Steered {
  std::optional<signals::BodyCommand> command;  ///< goes to locomotion; the session is filled in
  bool stops = false;                           ///< asks the supervisor to stop: every joint to null
  bool ends = false;                            ///< ends the run
};

/// A run of real processes over DDS. Member-independent options are in `common`.
struct DdsRun {
  DdsChoice dds = DdsChoice::kCyclone;
  run::Grouping grouping = run::Grouping::kPerLeg;
  participant::ProcessOptions common;
  std::string executables;     ///< directory of the node executables
  std::string locomotion;      ///< path of a program that runs in place of locomotion; empty: the shipped one
  bool no_locomotion = false;  ///< none is started: a process that somebody else starts takes its part
  std::string log_directory;
  std::string record_path;  ///< a recording of everything goes there; empty: none
  mcap::Text record_facts;  ///< recording::kRunFacts of it
  std::string title;
  std::map<std::string, std::vector<bus_faults::ArrowFault>> faults;  ///< by member, real time only
  std::vector<Act> acts;                                              ///< in the order of their ticks
  std::function<void(Tick)>
      looks_on;  ///< called with the newest tick the clock has begun; events are then heard at once; may be empty
  /// Called often with the newest tick and locomotion's newest state of the body: an operator at the terminal, in place
  /// of a bar. May be empty.
  std::function<Steered(Tick, const signals::BodyState&)> steers;
  std::vector<Onlooker> onlookers;
  double start_limit_s = 20.0;            ///< within which every participant must have greeted; 0: none
  double stall_limit_s = 30.0;            ///< lock-step: within which the next tick must begin; 0: none
  bool standby = false;                   ///< a second supervisor stands by, real time only
  bool goes_on_without_the_dead = false;  ///< real time: the death of any member is a warning
  bool soak = false;                      ///< watch what the processes grow by
  bool bare = false;  ///< exchange the same samples with nothing computed: the baseline of farrier bench
};

struct RunOutcome {
  std::vector<run::Member> members;            ///< the last is the launcher, where there are processes
  std::vector<signals::SystemHello> hellos;    ///< by participant
  std::vector<signals::SystemHealth> healths;  ///< by participant
  std::vector<signals::SystemEvent> events;
  std::vector<Tick> events_heard;  ///< newest tick of the clock then; by event
  std::vector<signals::JointUpdateDecision> decisions;
  std::vector<trace::TraceRow> rows;  ///< of the trace, in order; empty over DDS, where only the file has them
  std::vector<signals::JointControllerGains> gains;  ///< every update the supervisor issued
  std::vector<signals::GaitPhase> phases;            ///< changes of phase that joints were told
  std::vector<Tick> acted;                           ///< when acts were done, in their order
  std::vector<std::string> warnings;                 ///< what went wrong and did not end the run
  std::vector<std::optional<Growth>>
      growths;                         ///< by participant; nothing for one that died and for the launcher, which
                                       ///< keeps the record of the run. Empty where not watched
  std::vector<OnlookerUse> onlookers;  ///< as DdsRun has them
  double wall_s = 0;                   ///< from the first tick to the last
};

/// Starts every process, listens to them from this one, shows progress, ends every process. No process is left behind.
/// Refuses when a process dies (with its name, exit status and last lines), and when the user interrupts. Also refuses
/// when a limit of `run` is reached while no debugger is attached to a process of the run. In real time a run continues
/// with a warning without estimator_service and supervisors, gains and mode staying as they are, and without others as
/// `run` says.
Result<RunOutcome> run_over_dds(const robot::Robot& robot, const DdsRun& run);

}  // namespace farrier::cli
