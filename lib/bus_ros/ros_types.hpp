#pragma once

#include <dds/dds.h>

#include <string>

namespace farrier::bus_ros {

/// Cyclone's description of a message, by its name in ROS, "sensor_msgs/msg/JointState". Null for one that ros.idl lacks.
const dds_topic_descriptor_t* descriptor_of(const std::string& ros_name);

/// "sensor_msgs::msg::dds_::JointState_" of "sensor_msgs/msg/JointState".
std::string dds_type_name(const std::string& ros_name);

}  // namespace farrier::bus_ros
