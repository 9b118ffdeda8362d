#pragma once

#include <cstdint>
#include <string>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::web {

// JSON for the page; its names are explained in docs/monitoring.md. Numbers have six digits. A number that is not
// finite is null.

/// Facts of a robot that a page needs before its first frame: names, units, and the meanings of codes. `recorded`: the
/// frames come from a recording.
std::string robot_json(const robot::Robot& robot, bool recorded);

/// One frame. It is complete except for summaries and events, of which each frame has only its own. A page that missed
/// the frame before it still knows the whole present state.
std::string frame_json(const monitor::Frame& frame);

std::string event_json(const monitor::EventFrame& event);

}  // namespace farrier::web
