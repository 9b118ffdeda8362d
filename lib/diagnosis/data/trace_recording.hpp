#pragma once

#include <string>

#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// True if a file has the header of a trace (trace::TraceWriter); false for one that cannot be read.
bool is_trace(const std::string& path);

/// Coordinates of this joint's actuator, from its file.
Coordinates coordinates_of(const robot::Joint& joint);

/// One joint's rows of the trace of a run on `robot`, which gives the period. They are true values without noise: the
/// valve current that acts from each tick on, and swing where the simulated leg is in swing. Times are ticks times the
/// period. The `joint` must belong to `robot`. Refuses what read_recording does, and no_such_joint, with the names the
/// trace has.
Result<Recording, RecordingProblems> recording_of_trace(const std::string& path, const robot::Robot& robot,
                                                        const robot::Joint& joint);

}  // namespace farrier::diagnosis
