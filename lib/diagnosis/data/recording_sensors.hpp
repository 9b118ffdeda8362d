#pragma once

#include <vector>

#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// saturated and frozen of check_recording.
std::vector<Finding> check_sensors(const Recording& recording, const robot::Joint& joint);

}  // namespace farrier::diagnosis
