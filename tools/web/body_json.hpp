#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::web {

// Parts of the page's JSON that draw the robot in three dimensions. Lengths are in m, forces in N.

/// Shapes of a robot, which a page needs once: box of the trunk, first hinge and foot of each leg, weight. Null for a
/// robot whose file describes no rigid bodies.
nlohmann::json body_shapes(const robot::Robot& robot);

/// The robot in space at one frame; null for none.
nlohmann::json body_json(const std::optional<monitor::BodyFrame>& body);

}  // namespace farrier::web
