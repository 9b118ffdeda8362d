#pragma once

#include <string>
#include <vector>

#include "core/keep_on.hpp"
#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"
#include "tools/playback/measurements.hpp"

namespace farrier::offline {

/// What one joint measured, as diagnosis reads it: row k has the sensors of tick k, the valve current that acts from k
/// to k + 1, and swing 1 where the leg is in the air for certain. Where ticks are missing the longest stretch without
/// a hole, with a remark; empty for a joint without measurements. `joint` is one of `robot`.
diagnosis::Recording joint_recording(const playback::Measurements& measured, const robot::Robot& robot,
                                     const robot::Joint& joint);

/// The same of the recording at `path`. Refuses, as one finding of the file as a whole: unreadable; no_such_joint where
/// the recorded robot lacks the joint of this name, or nothing of it was recorded; too_short as read_recording does. What
/// comes before `keep_on` says no is all there is.
Result<diagnosis::Recording, diagnosis::RecordingProblems> read_joint_recording(const std::string& path,
                                                                                const std::string& joint,
                                                                                KeepOn keep_on = {});

}  // namespace farrier::offline
