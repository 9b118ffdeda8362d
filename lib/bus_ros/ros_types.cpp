#include "bus_ros/ros_types.hpp"

#include <algorithm>
#include <array>

#include "ros.h"

namespace farrier::bus_ros {
namespace {

// Gids of 24 bytes have the type's name on the wire that gids of 16 bytes have.
const dds_topic_descriptor_t& humble_graph() {
  static const dds_topic_descriptor_t renamed = [] {
    dds_topic_descriptor_t copy = rmw_dds_common_humble_msg_dds__ParticipantEntitiesInfo__desc;
    const_cast<const char*&>(copy.m_typename) = rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc.m_typename;
    return copy;
  }();
  return renamed;
}

}  // namespace

const dds_topic_descriptor_t* descriptor_of(const std::string& ros_name) {
  static const std::array kAll = {
      &std_msgs_msg_dds__String__desc,
      &std_msgs_msg_dds__Bool__desc,
      &geometry_msgs_msg_dds__Twist__desc,
      &geometry_msgs_msg_dds__TwistStamped__desc,
      &geometry_msgs_msg_dds__WrenchStamped__desc,
      &sensor_msgs_msg_dds__JointState__desc,
      &sensor_msgs_msg_dds__Imu__desc,
      &nav_msgs_msg_dds__Odometry__desc,
      &tf2_msgs_msg_dds__TFMessage__desc,
      &diagnostic_msgs_msg_dds__DiagnosticArray__desc,
      &rosgraph_msgs_msg_dds__Clock__desc,
      &rcl_interfaces_msg_dds__Log__desc,
      &control_msgs_msg_dds__DynamicJointState__desc,
      &rmw_dds_common_msg_dds__ParticipantEntitiesInfo__desc,
  };
  if (ros_name == "rmw_dds_common_humble/msg/ParticipantEntitiesInfo") {
    return &humble_graph();
  }
  const std::string name = dds_type_name(ros_name);
  const auto found = std::ranges::find_if(kAll, [&](const auto* descriptor) { return name == descriptor->m_typename; });
  return found == kAll.end() ? nullptr : *found;
}

std::string dds_type_name(const std::string& ros_name) {
  const std::size_t package_end = ros_name.find('/');
  const std::size_t type_begin = ros_name.rfind('/') + 1;
  return ros_name.substr(0, package_end) + "::msg::dds_::" + ros_name.substr(type_begin) + "_";
}

}  // namespace farrier::bus_ros
