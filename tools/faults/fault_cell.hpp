#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bus_faults/arrow_fault.hpp"
#include "gait/schedule.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "tools/faults/fault_rows.hpp"

namespace farrier::faults {

/// Ticks begin to end - 1.
struct TickSpan {
  Tick begin, end;
};

/// The joint that rows of Hit::kJoint are about: the last of the first leg.
const robot::Joint& hit_joint(const robot::Robot& robot);

/// Span of a row's fault, in `phase` of the hit joint's leg: in the middle of the phase if it is short enough, else
/// from shortly after its beginning on. In the first stride from `earliest` on that the leg begins that phase in.
TickSpan place_of(const robot::Robot& robot, const gait::Schedule& schedule, const Row& row, gait::Phase phase,
                  Tick earliest = 0);

/// The row's faults of samples at that time.
std::vector<bus_faults::ArrowFault> arrow_faults(const robot::Robot& robot, const Row& row, const TickSpan& span);

/// One thing that a cell must show.
struct Check {
  std::string key;    ///< in figures
  std::string what;   ///< for people
  double asked_s;     ///< 0: never
  double measured_s;  ///< infinite: not at all
  bool holds() const noexcept { return measured_s <= asked_s; }
};

/// The motion of the body of a robot on a ground from the beginning of the fault on.
struct BodyAfterFault {
  bool fell = false;             ///< by body::fall_of
  double not_walking_s = 0.0;    ///< fallen, or slower than half of the command over the last stride
  double trunk_speed_m_s = 0.0;  ///< largest, downwards
  double ground_force_N = 0.0;   ///< largest on a foot
};

/// The trot that a robot on a ground is asked for.
struct Walk {
  double speed_m_s;
  Tick stride_ticks;
  double period_s;
};

/// Judges the body's trace from `begin` on, which is more than a stride after the first step.
BodyAfterFault body_after_fault(const std::vector<signals::BodyTruth>& truth, Tick begin, const Walk& walk);

/// Check of rows under which a robot walks on.
Check walks_on_check(const BodyAfterFault& body);

/// One cell of the table, with its result.
struct Cell {
  std::string row, phase, vendor;
  std::uint64_t seed = 0;
  int repeats = 0;    ///< runs before in which the computer itself was stopped
  std::string error;  ///< why the run ended early; empty: it did not
  std::vector<Check> checks;
  std::optional<BodyAfterFault> body = std::nullopt;  ///< none on the bench
  bool holds() const noexcept;
  bool fell() const noexcept { return body && body->fell; }
};

/// Times of the events of a run. `armed`: the request to arm, the fault's end if there was none.
struct Moments {
  TickSpan fault;
  Tick armed;
  std::vector<TickSpan> pauses;  ///< in which the computer itself was stopped
};

/// An event that an operator heard, and the newest tick of the clock then.
struct Heard {
  std::string text;
  Tick tick;
};

/// Time before a fault from which on the joints that it does not hit are judged.
inline constexpr Tick kBefore = 50;

/// Time after a pause of the computer for which the joints that a fault does not hit are not judged. Waiting samples
/// are taken first, then a joint that had no sensors needs ten good samples.
inline constexpr Tick kAfterPause = 20;

/// Judges a row by the trace and the events of its run. Without a trace, which is missing if its writer was killed, the
/// events alone are judged.
std::vector<Check> judge(const robot::Robot& robot, const Row& row, const Moments& moments,
                         const std::vector<trace::TraceRow>& trace, const std::vector<Heard>& events);

}  // namespace farrier::faults
