#pragma once

#include <string>

namespace farrier::ros_view {

// Topics of a robot in ROS 2. A name with "/" in front is that of all robots, any other is in the robot's namespace.
inline constexpr const char* kJointStates = "joint_states";
inline constexpr const char* kDynamicJointStates = "dynamic_joint_states";
inline constexpr const char* kRobotDescription = "robot_description";
inline constexpr const char* kImu = "imu";
inline constexpr const char* kOdometry = "odom";
inline constexpr const char* kTransforms = "/tf";
inline constexpr const char* kDiagnostics = "/diagnostics";
inline constexpr const char* kLog = "/rosout";

/// Frame in the middle of a leg's foot, as farrier robot urdf names it.
inline std::string foot_frame(const std::string& leg) { return leg + "_foot"; }

/// "lf_foot/wrench"
inline std::string foot_wrench_topic(const std::string& leg) { return foot_frame(leg) + "/wrench"; }

}  // namespace farrier::ros_view
