#pragma once

#include "bus_ros/ros_endpoints.hpp"

namespace farrier::ros_bridge {

// QoS of the node's topics. Writers are reliable, so that readers of both kinds hear them.
inline constexpr bus_ros::RosQos kStreamQos{.reliable = true, .transient_local = false, .depth = 10};
inline constexpr bus_ros::RosQos kLatchedQos{.reliable = true, .transient_local = true, .depth = 1};
inline constexpr bus_ros::RosQos kLogQos{.reliable = true, .transient_local = true, .depth = 1000};
inline constexpr bus_ros::RosQos kTransformsQos{.reliable = true, .transient_local = false, .depth = 100};
inline constexpr bus_ros::RosQos kClockQos{.reliable = true, .transient_local = false, .depth = 1};

/// Hears reliable and best-effort writers alike. The depth leaves room for the first sender's messages beside those of
/// others, which are refused one by one.
inline constexpr bus_ros::RosQos kCommandsQos{.reliable = false, .transient_local = false, .depth = 64};

/// Hears reliable writers alone, and asks them for messages that are lost.
inline constexpr bus_ros::RosQos kRepeatedCommandsQos{.reliable = true, .transient_local = false, .depth = 64};

}  // namespace farrier::ros_bridge
