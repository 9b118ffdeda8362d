#pragma once

// Faults of a robot, the reaction of each process, and the time that it has. docs/faults.md is made from here.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/robot.hpp"
#include "run/process_act.hpp"
#include "signals/signals.hpp"

namespace farrier::faults {

/// Which joints a fault is about.
enum class Hit { kJoint, kLeg, kAll };

/// Robots that a row is about.
enum class Where {
  kEverywhere,
  kBench,   ///< joints on their bench loads alone
  kGround,  ///< a robot that walks on a ground alone
  kSupply   ///< a robot that walks on a ground and whose joints share a supply alone
};

using run::ProcessAct;

/// Reaction that a cell of the table must show of the joints that are hit. All others track throughout.
struct Expectation {
  /// State instead of tracking; kTracking: they continue as before.
  signals::JointState reaction = signals::JointState::kTracking;
  double within_s = 0.0;        ///< of the beginning
  double recovers_s = 0.0;      ///< tracking again, of the fault's end or of the request to arm; 0: they never do
  bool may_stutter = false;     ///< they may leave tracking for short and come back by themselves, in any state
  bool latches = false;         ///< they trip, and track again only after a request to arm
  const char* event = nullptr;  ///< part of an event that an operator sees; null: none is asked for
  double event_within_s = 0.2;  ///< of the beginning
};

struct Row {
  const char* name;
  const char* fault;  ///< what happens, for people
  const char* does;   ///< what each process does, for people
  Hit hit;
  const char* member;               ///< into which corrupted samples come; null: none
  std::vector<const char*> arrows;  ///< bus_faults::parse_arrow_fault without span and key
  double lasts_s;                   ///< from its beginning to its end; by the computer's clock where that is set
  std::vector<ProcessAct> acts;
  Expectation expected;
  bool standby = false;                           ///< a second supervisor stands by
  robot::Design design = robot::Design::kPhases;  ///< of the supervisor
  Where where = Where::kEverywhere;
};

const std::vector<Row>& rows();

/// True if a run with this fault ends with a trace: false if its writer is killed.
bool leaves_trace(const Row& row);

/// True for a row of such robots. A robot of kSupply has the rows of kGround, too.
bool is_row_of(const Row& row, Where robot);

/// True if all joints continue to track under the fault, so that a robot on a ground must walk on.
bool walks_on(const Row& row);

/// True if a process starts in a run with this fault.
bool starts_process(const Row& row);

/// Factor by which rows in which a process starts are slower than the others: loading a program takes a computer as
/// long at any pace of the robot's clock.
inline constexpr int kSlowerWhereProcessesStart = 3;

/// The row in slow motion: times by the computer's clock, which is set, are shorter by this factor on the robot's.
Row paced(Row row, int slow);

/// Null for none of that name.
const Row* find_row(std::string_view name);

}  // namespace farrier::faults
