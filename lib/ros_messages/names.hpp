#pragma once

#include <string>

namespace farrier::ros_messages {

/// The full name of a topic in ROS: "/hyq/joint_states". `topic` is such a name itself, or one in `ros_namespace`, which is
/// "/" or "/hyq".
inline std::string full_name(const std::string& ros_namespace, const std::string& topic) {
  if (topic.starts_with('/')) {
    return topic;
  }
  return (ros_namespace == "/" ? "" : ros_namespace) + "/" + topic;
}

}  // namespace farrier::ros_messages
