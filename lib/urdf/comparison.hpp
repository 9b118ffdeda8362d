#pragma once

#include <string>
#include <vector>

#include "robot/robot.hpp"
#include "urdf/urdf_model.hpp"

namespace farrier::urdf {

/// One difference between a URDF and a robot file.
struct Difference {
  std::string where;    ///< joint of the robot file, "trunk", or empty for the robot as a whole
  std::string message;  ///< both values: "mass 2.95 kg, in the robot file 2.93 kg"
};

struct Comparison {
  std::vector<Difference> differences;     ///< empty: both describe the same mechanism
  std::vector<std::string> only_in_urdf;   ///< what the URDF has and a robot file has no place for
  std::vector<std::string> only_in_robot;  ///< what the robot file has and a URDF has no place for
  int compared_joints = 0;
};

/// Values count as equal within these.
struct Tolerances {
  double relative = 1e-3;  ///< masses, efforts, speeds, dampings; tensors against their largest principal moment
  double length_m = 1e-4;
  double angle_rad = 1e-3;
};

/// Compares masses, centres of mass, inertias about them, joint positions, axes with their signs, and limits, all in the
/// axes of the URDF's root link at angles of zero, which must be the trunk's. A joint of the URDF belongs to the one of
/// its name, upper or lower case, with or without "_joint" at its end. Joints of a leg without such a name are those of
/// the leg nearest to its hip. Links on fixed joints count to the body that they move with. The robot must have a body.
Comparison compare(const UrdfModel& urdf, const robot::Robot& robot, const Tolerances& tolerances = {});

}  // namespace farrier::urdf
