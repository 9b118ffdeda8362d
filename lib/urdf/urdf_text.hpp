#pragma once

#include <string>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::urdf {

/// The robot as a URDF: what body and joints of its file say, in XML.
///
/// - Joints have the names of the robot file, and a positive angle means the same. All frames are parallel to the trunk's
///   at angles of zero, so no origin has a rotation.
/// - base_link is the root, at the trunk's origin and without inertia, since robot_state_publisher refuses one there.
///   Links are trunk, <leg>_hip, <leg>_upper_leg, <leg>_lower_leg and <leg>_foot, a frame in the foot's middle.
/// - Inertias are about the centre of mass. Shapes are boxes, cylinders and spheres; what collides is what meets the
///   ground in Farrier's world.
/// - Limits are those of limits_of(); damping is that of the bearings.
///
/// Refuses a robot without body.trunk.
Result<std::string> urdf_text(const robot::Robot& robot);

/// Names of the links that turn with the joints of a leg, from the trunk outwards.
inline constexpr const char* kLinksOfALeg[] = {"hip", "upper_leg", "lower_leg"};

}  // namespace farrier::urdf
