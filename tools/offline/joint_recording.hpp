#pragma once

#include <string>
#include <vector>

#include "core/keep_on.hpp"
#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"
#include "tools/playback/measurements.hpp"

namespace farrier::offline {

/// One joint's measurements as a recording for diagnosis. Row k has the sensors of tick k, the valve current that acts
/// from k to k + 1, and swing 1 where the leg is in the air for certain. If ticks are missing, it is the longest
/// stretch without a hole, with a remark. Empty for a joint without measurements. `joint` is one of `robot`.
diagnosis::Recording joint_recording(const playback::Measurements& measured, const robot::Robot& robot,
                                     const robot::Joint& joint);

/// The same of the recording at `path`, up to the point at which `keep_on` returns false. Refuses, as one finding of
/// the file as a whole: unreadable; no_such_joint if the recorded robot lacks the joint of this name, or nothing of it
/// was recorded; too_short as read_recording does.
Result<diagnosis::Recording, diagnosis::RecordingProblems> read_joint_recording(const std::string& path,
                                                                                const std::string& joint,
                                                                                KeepOn keep_on = {});

}  // namespace farrier::offline
