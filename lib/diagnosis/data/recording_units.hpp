#pragma once

#include <array>
#include <vector>

#include "core/units.hpp"
#include "diagnosis/data/recording.hpp"
#include "robot/robot.hpp"

namespace farrier::diagnosis {

/// A unit somebody may have recorded in.
struct Unit {
  const char* name;
  double per_SI;  ///< how many of it are one of ours
};

inline constexpr std::array kPressureUnits{Unit{"bar", 1e-5}, Unit{"megapascals", 1e-6},
                                           Unit{"pounds per square inch", 1.0 / kPascalPerPsi},
                                           Unit{"kilopascals", 1e-3}};

/// False for angles of a cylinder and for positions in metres of an electric joint. Chambers of a vane motor have equal
/// areas. So have those of a cylinder with two rods, which this test cannot distinguish.
bool has_coordinates_of(const Recording& recording, const robot::Joint& joint);

/// wrong_coordinates, wrong_units, out_of_range, wrong_sign and inconsistent of check_recording.
std::vector<Finding> check_units(const Recording& recording, const robot::Joint& joint);

}  // namespace farrier::diagnosis
