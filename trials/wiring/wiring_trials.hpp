#pragma once

// Trials of find_wiring: faults put into recordings of trials/truth, and recordings without a fault.

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/wiring/wiring.hpp"
#include "robot/robot.hpp"
#include "trials/blind/blind_trials.hpp"

namespace farrier::wiring {

/// Answers to one kind of fault, over its recordings.
struct KindScore {
  std::string name;
  int recordings = 0;
  int first = 0;     ///< the fault is named first: kind, channel and amount
  int possible = 0;  ///< it is among those named, the first included
  int wrong = 0;     ///< others are named alone
};

/// True if an answer is that fault: the same kind, channels and joint; of lags and factors within 10 % and one sample.
bool is_fault(const diagnosis::WiringFault& answer, const diagnosis::WiringFault& fault) noexcept;

/// The recording that a truth's samples are, all of its channels included.
diagnosis::Recording recording_of(const truth::Samples& samples, const robot::Joint& joint);

/// Every kind in kRecordings recordings, of `joints` in turn under all excitations; others are of the next joint.
/// `joints` are those of `truth::generate`, all hydraulic or all electric, at least two. Refuses what the generator does.
Result<std::vector<KindScore>> run_wiring_trials(const std::vector<const robot::Joint*>& joints, std::uint64_t seed);

/// The same over a whole robot: two joints have their cables of one channel exchanged, in kRecordings pairs for each of
/// four channels, and each recording is judged beside those of all joints. Named means that both joints name the other. The
/// last score counts the joints whose cables are right: a name for one of them is `wrong`.
Result<std::vector<KindScore>> run_robot_wiring_trials(const robot::Robot& robot, std::uint64_t seed);

/// Blind trials in which a fault of wiring was named, as "trial 12, valve_bias: ...". Each is judged with and without its
/// pressures. `done` is called after each trial; if it returns false, the rest is left out.
std::vector<std::string> false_alarms(const std::vector<blind::TrialPlan>& plans,
                                      const std::vector<const robot::Joint*>& joints, int threads,
                                      const std::function<bool()>& done);

}  // namespace farrier::wiring
