#include "ros_view/conversions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "config/visitor.hpp"
#include "core/fault.hpp"
#include "ros_view/topics.hpp"

namespace farrier::ros_view {

namespace {

constexpr std::byte kOk{0}, kWarn{1}, kError{2}, kStale{3};
constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// A joint's reading behind its linkage.
struct JointReading {
  double position_rad, velocity_rad_s, effort_Nm;
};

/// Empty before the first sample, and where a number is not finite.
std::optional<JointReading> reading_of(const robot::Joint& joint, const signals::JointSensors& sensors) {
  if (sensors.tick == kNoTick) {
    return std::nullopt;
  }
  const double q = joint.linkage.angle(sensors.position_m_or_rad);
  const JointReading reading{q, joint.linkage.angular_velocity(q, sensors.velocity_m_s_or_rad_s),
                             joint.linkage.torque(q, sensors.force_N_or_Nm)};
  const bool finite = std::isfinite(q) && std::isfinite(reading.velocity_rad_s) && std::isfinite(reading.effort_Nm);
  return finite ? std::optional(reading) : std::nullopt;
}

template <class Values>
bool all_finite(const Values& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

Eigen::Quaterniond attitude_of(const signals::BodyState& state) {
  return {state.attitude[0], state.attitude[1], state.attitude[2], state.attitude[3]};
}

/// Rotation from the axes of a leg's last link to those of the trunk; none if a joint is not heard.
std::optional<Eigen::Quaterniond> last_link_rotation(const robot::Robot& robot, std::size_t leg,
                                                     std::span<const JointSamples> joints) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  for (const robot::Joint& joint : robot.joints) {  // from the trunk outwards
    if (static_cast<std::size_t>(joint.leg) != leg) {
      continue;
    }
    const auto reading = reading_of(joint, joints[joint.number].sensors);
    if (!reading) {
      return std::nullopt;
    }
    const Eigen::Vector3d& axis = robot.body->legs[leg].links[static_cast<std::size_t>(joint.index_in_leg)].axis;
    rotation = rotation * Eigen::AngleAxisd(reading->position_rad, axis);
  }
  return rotation;
}

geometry_msgs::Vector3 vector_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
geometry_msgs::Vector3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Sets the level if it is worse than the one there; a stale status stays so.
void raise(diagnostic_msgs::DiagnosticStatus& status, std::byte level) { status.level = std::max(status.level, level); }

diagnostic_msgs::DiagnosticStatus joint_status(const robot::Joint& joint, const monitor::JointFrame& frame) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = "joint " + joint.name;
  if (!(frame.age_s < monitor::kSilent_s)) {
    status.level = kStale;
    status.message = "silent";
    return status;
  }
  for (const FaultInfo& fault : kFaults) {
    if ((frame.faults & static_cast<std::uint32_t>(fault.fault)) == 0) {
      continue;
    }
    status.message += (status.message.empty() ? "" : ", ") + std::string(fault.name);
    raise(status, fault.severity >= FaultSeverity::kError     ? kError
                  : fault.severity == FaultSeverity::kWarning ? kWarn
                                                              : kOk);
  }
  if (status.message.empty()) {
    status.message = "tracks";
  }
  status.values = {{"rate_Hz", config::number_text(frame.rate_Hz)},
                   {"missed_ticks", std::to_string(frame.missed_ticks)},
                   {"force_error_rms", config::number_text(frame.force_error_rms)}};
  return status;
}

diagnostic_msgs::DiagnosticStatus process_status(const monitor::ParticipantFrame& process) {
  diagnostic_msgs::DiagnosticStatus status;
  status.name = "process " + std::string(signals::text_of(process.hello.name));
  const bool silent = process.health.tick != kNoTick && !(process.age_s < 5.0 * monitor::kSilent_s);
  status.level = silent ? kStale : process.lost() > 0 ? kWarn : kOk;
  status.message = silent ? "silent" : process.lost() > 0 ? "has lost samples" : "runs";
  status.values = {{"pid", std::to_string(process.hello.pid)},
                   {"lost_samples", std::to_string(process.lost())},
                   {"missed_periods", std::to_string(process.health.missed_periods)}};
  return status;
}

}  // namespace

Time time_of(std::int64_t ns) noexcept {
  const std::int64_t positive = std::max<std::int64_t>(ns, 0);
  return {.sec = static_cast<std::int32_t>(positive / kSecond_ns),
          .nanosec = static_cast<std::uint32_t>(positive % kSecond_ns)};
}

sensor_msgs::JointState joint_state(const robot::Robot& robot, std::span<const JointSamples> joints,
                                    const Time& stamp) {
  sensor_msgs::JointState message;
  message.header.stamp = stamp;
  for (const robot::Joint& joint : robot.joints) {
    if (const auto reading = reading_of(joint, joints[joint.number].sensors)) {
      message.name.push_back(joint.name);
      message.position.push_back(reading->position_rad);
      message.velocity.push_back(reading->velocity_rad_s);
      message.effort.push_back(reading->effort_Nm);
    }
  }
  return message;
}

control_msgs::DynamicJointState dynamic_joint_state(const robot::Robot& robot, std::span<const JointSamples> joints,
                                                    const Time& stamp) {
  control_msgs::DynamicJointState message;
  message.header.stamp = stamp;
  for (const robot::Joint& joint : robot.joints) {
    const JointSamples& samples = joints[joint.number];
    const auto reading = reading_of(joint, samples.sensors);
    if (!reading) {
      continue;
    }
    control_msgs::InterfaceValue values;
    const auto add = [&](const char* name, double value) {
      if (std::isfinite(value)) {
        values.interface_names.emplace_back(name);
        values.values.push_back(value);
      }
    };
    add("position", reading->position_rad);
    add("velocity", reading->velocity_rad_s);
    add("effort", reading->effort_Nm);
    add("force", samples.sensors.force_N_or_Nm);
    if (samples.summary.tick != kNoTick) {
      add("force_reference", samples.summary.force_reference_N_or_Nm);
      add("valve_current", samples.summary.valve_current_A);
      add("gain_generation", samples.summary.generation);
      add("faults", samples.summary.faults);
    }
    message.joint_names.push_back(joint.name);
    message.interface_values.push_back(std::move(values));
  }
  return message;
}

std::optional<sensor_msgs::Imu> imu(const signals::BodyImu& reading, const Time& stamp) {
  if (!all_finite(reading.angular_velocity_rad_s) || !all_finite(reading.specific_force_m_s2)) {
    return std::nullopt;
  }
  sensor_msgs::Imu message;
  message.header = {.stamp = stamp, .frame_id = kBaseFrame};
  message.orientation.w = 1.0;
  message.orientation_covariance[0] = -1.0;
  message.angular_velocity = vector_of(reading.angular_velocity_rad_s);
  message.linear_acceleration = vector_of(reading.specific_force_m_s2);
  return message;
}

std::optional<nav_msgs::Odometry> odometry(const signals::BodyState& state, const Time& stamp) {
  if (!all_finite(state.position_m) || !all_finite(state.attitude) || !all_finite(state.velocity_m_s) ||
      !all_finite(state.angular_velocity_rad_s)) {
    return std::nullopt;
  }
  const Eigen::Quaterniond attitude = attitude_of(state);
  const Eigen::Vector3d velocity_m_s(state.velocity_m_s[0], state.velocity_m_s[1], state.velocity_m_s[2]);
  nav_msgs::Odometry message;
  message.header = {.stamp = stamp, .frame_id = kOdomFrame};
  message.child_frame_id = kBaseFrame;
  message.pose.pose.position = {state.position_m[0], state.position_m[1], state.position_m[2]};
  message.pose.pose.orientation = {attitude.x(), attitude.y(), attitude.z(), attitude.w()};
  message.twist.twist.linear = vector_of(attitude.conjugate() * velocity_m_s);
  message.twist.twist.angular = vector_of(state.angular_velocity_rad_s);
  return message;
}

tf2_msgs::TFMessage transform(const nav_msgs::Odometry& odometry) {
  geometry_msgs::TransformStamped stamped;
  stamped.header = odometry.header;
  stamped.child_frame_id = odometry.child_frame_id;
  const geometry_msgs::Point& position = odometry.pose.pose.position;
  stamped.transform.translation = {position.x, position.y, position.z};
  stamped.transform.rotation = odometry.pose.pose.orientation;
  return {.transforms = {stamped}};
}

std::optional<geometry_msgs::WrenchStamped> foot_wrench(const robot::Robot& robot, std::size_t leg,
                                                        const signals::BodyState& state,
                                                        std::span<const JointSamples> joints, const Time& stamp) {
  const auto rotation = last_link_rotation(robot, leg, joints);
  const Eigen::Map<const Eigen::Vector3d> force_N(state.felt_force_N.data() + 3 * leg);
  if (!rotation || !force_N.allFinite() || !all_finite(state.attitude)) {
    return std::nullopt;
  }
  geometry_msgs::WrenchStamped message;
  message.header = {.stamp = stamp, .frame_id = foot_frame(robot.body->legs[leg].name)};
  message.wrench.force = vector_of((attitude_of(state) * *rotation).conjugate() * force_N);
  return message;
}

diagnostic_msgs::DiagnosticArray diagnostics(const robot::Robot& robot, const monitor::Frame& frame,
                                             const Time& stamp) {
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = stamp;
  diagnostic_msgs::DiagnosticStatus whole;
  whole.name = "robot";
  whole.level = frame.mode.epoch == 0 ? kStale : kOk;
  whole.message = frame.mode.epoch == 0 ? "no mode heard" : signals::to_string(frame.mode.mode);
  whole.values = {{"tick", std::to_string(frame.tick)}, {"lost_samples", std::to_string(frame.lost_samples)}};
  message.status.push_back(std::move(whole));
  for (const robot::Joint& joint : robot.joints) {
    if (joint.number < frame.joints.size()) {
      message.status.push_back(joint_status(joint, frame.joints[joint.number]));
    }
  }
  for (const monitor::ParticipantFrame& process : frame.participants) {
    if (!signals::text_of(process.hello.name).empty()) {
      message.status.push_back(process_status(process));
    }
  }
  for (diagnostic_msgs::DiagnosticStatus& status : message.status) {
    status.name = robot.name + ": " + status.name;
    status.hardware_id = robot.name;
  }
  return message;
}

rcl_interfaces::Log log_line(const monitor::EventFrame& event, const std::string& node, const Time& stamp) {
  constexpr std::uint8_t kInfoLevel = 20, kWarnLevel = 30, kErrorLevel = 40;
  rcl_interfaces::Log line;
  line.stamp = stamp;
  line.level = event.severity == signals::Severity::kError     ? kErrorLevel
               : event.severity == signals::Severity::kWarning ? kWarnLevel
                                                               : kInfoLevel;
  line.name = node + "." + event.who;
  line.msg = event.joint.empty() ? event.text : event.joint + ": " + event.text;
  return line;
}

}  // namespace farrier::ros_view
