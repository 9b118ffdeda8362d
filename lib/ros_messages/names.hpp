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

/// Why a namespace is none that ROS can have; empty: it can.
inline std::string namespace_error(const std::string& text) {
  const bool good = text == "/" || (text.size() > 1 && text.front() == '/' && text.back() != '/' &&
                                    text.find("//") == std::string::npos &&
                                    text.find_first_not_of("/_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                           "0123456789") == std::string::npos);
  return good ? "" : "give / or a name like /hyq, of letters, digits and _";
}

}  // namespace farrier::ros_messages
