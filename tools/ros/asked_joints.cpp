#include "tools/ros/asked_joints.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/visitor.hpp"

namespace farrier::ros_bridge {
namespace {

/// A name of a message as an error shows it: at most 40 printable characters.
std::string shown(const std::string& name) {
  constexpr std::size_t kMost = 40;
  std::string text = name.substr(0, kMost);
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (name.size() > kMost ? "...'" : "'");
}

/// Joints by their place in the message, at least one; refuses names that the robot does not have, or that come twice.
Result<std::vector<const robot::Joint*>> joints_of(const robot::Robot& robot, const std::vector<std::string>& names) {
  if (names.empty()) {
    return Error{"it names no joint"};
  }
  std::vector<const robot::Joint*> joints;
  std::vector<bool> named(robot.joints.size(), false);
  for (const std::string& name : names) {
    const robot::Joint* const joint = robot.find(name);
    if (joint == nullptr) {
      return Error{robot.name + " has no joint " + shown(name)};
    }
    if (named[joint->number]) {
      return Error{"joint " + joint->name + " comes twice"};
    }
    named[joint->number] = true;
    joints.push_back(joint);
  }
  return joints;
}

/// One number of a message; none for NaN.
Result<std::optional<double>> number(const robot::Joint& joint, const char* interface, double value) {
  if (std::isinf(value)) {
    return Error{joint.name + ": " + interface + " is infinite"};
  }
  return std::isnan(value) ? std::optional<double>() : std::optional(value);
}

Result<Done> take_array(const std::vector<const robot::Joint*>& joints, const std::vector<double>& values,
                        const char* interface, std::optional<double> AskedJoint::*field,
                        std::vector<AskedJoint>& asked) {
  if (values.empty()) {
    return Done{};
  }
  if (values.size() != joints.size()) {
    return Error{std::string(interface) + " has " + std::to_string(values.size()) + " numbers for " +
                 std::to_string(joints.size()) + " names: give one for each joint, NaN where it is not commanded"};
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    asked[joints[i]->number].*field = FARRIER_TRY(number(*joints[i], interface, values[i]));
  }
  return Done{};
}

/// An interface of a command by its name.
struct Interface {
  const char* name;
  std::optional<double> AskedJoint::*field;
  double robot::Joint::*own;  ///< gain of the robot file; null: no gain
};
constexpr Interface kInterfaces[] = {
    {"position", &AskedJoint::position_rad, nullptr},
    {"velocity", &AskedJoint::velocity_rad_s, nullptr},
    {"effort", &AskedJoint::effort_Nm, nullptr},
    {"kp", &AskedJoint::stiffness_Nm_rad, &robot::Joint::stiffness_Nm_rad},
    {"proportional", &AskedJoint::stiffness_Nm_rad, &robot::Joint::stiffness_Nm_rad},
    {"kd", &AskedJoint::damping_Nms_rad, &robot::Joint::damping_Nms_rad},
    {"derivative", &AskedJoint::damping_Nms_rad, &robot::Joint::damping_Nms_rad},
};

Result<Done> take_interface(const robot::Joint& joint, const std::string& name, double value, AskedJoint& asked) {
  const auto* const interface =
      std::ranges::find_if(kInterfaces, [&](const Interface& known) { return known.name == name; });
  if (interface == std::end(kInterfaces)) {
    return Error{joint.name + " has no interface " + shown(name) +
                 ": give position, velocity, effort, kp or proportional, kd or derivative"};
  }
  std::optional<double>& field = asked.*(interface->field);
  if (field) {
    return Error{joint.name + ": " + interface->name + " comes twice"};
  }
  field = FARRIER_TRY(number(joint, interface->name, value));
  if (interface->own != nullptr && field && !(*field >= 0.0 && *field <= kMostGains * joint.*(interface->own))) {
    return Error{joint.name + ": " + interface->name + " of " + config::number_text(*field) + " is outside 0.." +
                 config::number_text(kMostGains * joint.*(interface->own))};
  }
  return Done{};
}

}  // namespace

Result<std::vector<AskedJoint>> asked_joints(const robot::Robot& robot,
                                             const ros_messages::sensor_msgs::JointState& message) {
  const auto joints = FARRIER_TRY(joints_of(robot, message.name));
  std::vector<AskedJoint> asked(robot.joints.size());
  FARRIER_TRY(take_array(joints, message.position, "position", &AskedJoint::position_rad, asked));
  FARRIER_TRY(take_array(joints, message.velocity, "velocity", &AskedJoint::velocity_rad_s, asked));
  FARRIER_TRY(take_array(joints, message.effort, "effort", &AskedJoint::effort_Nm, asked));
  return asked;
}

Result<std::vector<AskedJoint>> asked_joints(const robot::Robot& robot,
                                             const ros_messages::control_msgs::DynamicJointState& message) {
  const auto joints = FARRIER_TRY(joints_of(robot, message.joint_names));
  if (message.interface_values.size() != joints.size()) {
    return Error{"interface_values has " + std::to_string(message.interface_values.size()) + " entries for " +
                 std::to_string(joints.size()) + " names"};
  }
  std::vector<AskedJoint> asked(robot.joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& [names, values] = message.interface_values[i];
    if (names.size() != values.size()) {
      return Error{joints[i]->name + " has " + std::to_string(values.size()) + " values for " +
                   std::to_string(names.size()) + " interfaces"};
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      FARRIER_TRY(take_interface(*joints[i], names[k], values[k], asked[joints[i]->number]));
    }
  }
  return asked;
}

}  // namespace farrier::ros_bridge
