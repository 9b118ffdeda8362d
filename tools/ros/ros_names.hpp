#pragma once

// Names of other libraries that the parts of the node use.

#include "recorder/polling.hpp"
#include "ros_messages/messages.hpp"
#include "ros_view/conversions.hpp"

namespace farrier::ros_bridge {

namespace control_msgs = ros_messages::control_msgs;
namespace diagnostic_msgs = ros_messages::diagnostic_msgs;
namespace geometry_msgs = ros_messages::geometry_msgs;
namespace nav_msgs = ros_messages::nav_msgs;
namespace rcl_interfaces = ros_messages::rcl_interfaces;
namespace rosgraph_msgs = ros_messages::rosgraph_msgs;
namespace sensor_msgs = ros_messages::sensor_msgs;
namespace std_msgs = ros_messages::std_msgs;
namespace tf2_msgs = ros_messages::tf2_msgs;

using recorder::Due;
using recorder::Newest;
using recorder::polled_endpoint;
using ros_view::Time;

}  // namespace farrier::ros_bridge
