#pragma once

#include <vector>

#include "tools/playback/recorded_run.hpp"

namespace farrier::playback {

/// Measurements of all joints in a recorded run.
struct Measurements {
  bool lockstep = false;  ///< which clock the run had: only lock-step has clock/tick_done
  std::vector<std::vector<signals::JointMeasurement>> joints;  ///< by number, ticks rising
  std::string ending;                                          ///< of the file: RecordedRun::ending
  std::uint64_t late = 0;  ///< measurements left out because their tick had come already, as in a second run

  int loop_delay_ticks(const robot::Robot& robot) const noexcept {
    return lockstep ? robot.loop_delay_lockstep : robot.loop_delay_realtime;
  }
};

/// Reads a run to its end, without repeated and late ticks. `others` gets every other topic's samples; may be empty.
Measurements read_measurements(RecordedRun& run, const recording::TakeSample& others = {});

}  // namespace farrier::playback
