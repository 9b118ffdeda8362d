#pragma once

#include <vector>

#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// Returns the defects of data that could be read, judged by the joint's limits, by line; empty if there are none. At
/// most one finding of a kind in a column (saturated: one for either end). A recording without motion has no fault in
/// its data.
///
/// "wrong_coordinates": the recording is of a rotary motor, and the joint's chambers differ in area. "wrong_units":
/// position, velocity, force, current or pressure look like another unit, or like none. "out_of_range": positions are
/// outside the stroke by more than 2 % of it. "wrong_sign", "inconsistent": the velocity contradicts the derivative of
/// the position. "saturated": a sensor stays at one extreme for 20 samples and more at a time, 1 % of all, while others
/// move. The valve current is saturated if it is at its limit in more than half of the samples. "frozen": a sensor is
/// constant throughout while others move, or as long as a saturated one between its extremes (50 samples and more at a
/// time).
///
/// A chamber at the return pressure, where oil cavitates, and a constant supply pressure are not faults.
std::vector<Finding> check_recording(const Recording& recording, const robot::Joint& joint);

/// The recording with the current that its torque command asks of an electric joint's drive, where it has no current;
/// others as they are.
Recording with_current(Recording recording, const robot::Joint& joint);

}  // namespace farrier::diagnosis
