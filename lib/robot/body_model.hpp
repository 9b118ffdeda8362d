#pragma once

#include <optional>

#include "body/model/body_model.hpp"
#include "robot/robot_file.hpp"

namespace farrier::robot {

/// The robot as rigid bodies, from the sections body and legs; none without body.trunk. Signs are those of
/// gait/leg_kinematics.hpp: HAA turns about -x on the left and +x on the right, HFE and KFE about +y. The file must
/// have passed check_body. Armatures are zero and hinges have no stops: they are the actuators'.
std::optional<body::BodyModel> make_body_model(const RobotFile& file);

/// The trunk's inertia by itself. The file must have body.trunk.
body::RigidInertia trunk_inertia(const Body& body);

/// A link's inertia in axes parallel to the trunk's, for a left front leg with all angles zero.
body::RigidInertia hip_inertia(const Link& hip);
body::RigidInertia leg_link_inertia(const Link& upper_or_lower_leg);

}  // namespace farrier::robot
