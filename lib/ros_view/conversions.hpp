#pragma once

// Samples of a robot as messages of ROS 2: SI units, right-handed axes with x forward, y left and z up (REP 103), frames
// odom and base_link (REP 105), base_link in the trunk's origin. No number in a message is infinite or not a number.

#include <optional>
#include <span>

#include "monitor/frame.hpp"
#include "robot/robot.hpp"
#include "ros_messages/messages.hpp"
#include "signals/signals.hpp"

namespace farrier::ros_view {

namespace control_msgs = ros_messages::control_msgs;
namespace diagnostic_msgs = ros_messages::diagnostic_msgs;
namespace geometry_msgs = ros_messages::geometry_msgs;
namespace nav_msgs = ros_messages::nav_msgs;
namespace rcl_interfaces = ros_messages::rcl_interfaces;
namespace sensor_msgs = ros_messages::sensor_msgs;
namespace tf2_msgs = ros_messages::tf2_msgs;

using ros_messages::builtin_interfaces::Time;

inline constexpr const char* kBaseFrame = "base_link";
inline constexpr const char* kOdomFrame = "odom";

/// `ns` since 1970, or since the begin of a simulation; at least 0.
Time time_of(std::int64_t ns) noexcept;

/// Newest samples of a joint; a tick of kNoTick: none yet.
struct JointSamples {
  signals::JointSensors sensors;
  signals::JointSummary summary;
};

/// Angles, velocities and torques of all joints that have a sample, in the robot's order: actuator readings through the
/// linkage. The arrays are equally long.
sensor_msgs::JointState joint_state(const robot::Robot& robot, std::span<const JointSamples> joints, const Time& stamp);

/// The same with more interfaces by joint: position, velocity, effort, and of the actuator force, force_reference,
/// valve_current, gain_generation and faults.
control_msgs::DynamicJointState dynamic_joint_state(const robot::Robot& robot, std::span<const JointSamples> joints,
                                                    const Time& stamp);

/// The IMU's reading; its attitude counts as not measured (covariance -1). None if a number is not finite.
std::optional<sensor_msgs::Imu> imu(const signals::BodyImu& reading, const Time& stamp);

/// The trunk as locomotion believes it to be; the twist is in the axes of base_link. Covariances are unknown: 0. None if a
/// number is not finite.
std::optional<nav_msgs::Odometry> odometry(const signals::BodyState& state, const Time& stamp);

/// The same as a transform from odom to base_link.
tf2_msgs::TFMessage transform(const nav_msgs::Odometry& odometry);

/// The force of the ground on a foot as locomotion feels it by the joint torques, in the frame of the foot, of which the
/// origin is the middle of the foot's sphere. The torque is 0: a foot is a point. `leg` is a place in Robot::body. Empty
/// if a joint of the leg is not heard, or a number is not finite.
std::optional<geometry_msgs::WrenchStamped> foot_wrench(const robot::Robot& robot, std::size_t leg,
                                                        const signals::BodyState& state,
                                                        std::span<const JointSamples> joints, const Time& stamp);

/// A status of the robot, of each joint and of each process.
diagnostic_msgs::DiagnosticArray diagnostics(const robot::Robot& robot, const monitor::Frame& frame, const Time& stamp);

/// An event as a line of the log of `node`.
rcl_interfaces::Log log_line(const monitor::EventFrame& event, const std::string& node, const Time& stamp);

}  // namespace farrier::ros_view
