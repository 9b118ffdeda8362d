#pragma once

#include "bus/bus.hpp"
#include "robot/robot.hpp"

namespace farrier::recorder {

/// The reading end of somebody who only watches: every route of the topic, no stream's writer waits for him. `depth`:
/// samples of a key that are kept until he looks.
bus::EndpointSpec watching_endpoint(const robot::Robot& robot, bus::TopicId topic, int depth = 16);

}  // namespace farrier::recorder
