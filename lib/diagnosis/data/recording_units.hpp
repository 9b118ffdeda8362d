#pragma once

#include <vector>

#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// wrong_coordinates, wrong_units, out_of_range, wrong_sign and inconsistent of check_recording.
std::vector<Finding> check_units(const Recording& recording, const robot::Joint& joint);

}  // namespace farrier::diagnosis
