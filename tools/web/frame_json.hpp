#pragma once

#include <cstdint>
#include <string>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"

namespace farrier::web {

// What the page reads; its names are explained in docs/monitoring.md. Numbers have six digits, what is not a finite
// number is null.

/// What a page needs to know of a robot before its first frame: names, units, and what codes stand for. `recorded`: the
/// frames come from a recording.
std::string robot_json(const robot::Robot& robot, bool recorded);

/// One frame. Whole but for summaries and events, which each frame has its own of: who missed the frame before it still
/// knows all that holds now.
std::string frame_json(const monitor::Frame& frame);

std::string event_json(const monitor::EventFrame& event);

}  // namespace farrier::web
