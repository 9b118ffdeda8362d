// Messages as any node of ROS 2 may send them, and URDF files as people write them. The first byte of a message is its type.

#include <cmath>
#include <tuple>

#include "ros_messages/cdr.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/robots.hpp"
#include "tools/ros/asked_joints.hpp"
#include "urdf/urdf_reader.hpp"

namespace farrier::fuzz {
namespace {

namespace msgs = ros_messages;

/// Messages that the node takes from others, and some with each kind of field.
using Types = std::tuple<msgs::std_msgs::Bool, msgs::geometry_msgs::Twist, msgs::geometry_msgs::TwistStamped,
                         msgs::sensor_msgs::JointState, msgs::control_msgs::DynamicJointState, msgs::std_msgs::String,
                         msgs::diagnostic_msgs::DiagnosticArray, msgs::rmw_dds_common::ParticipantEntitiesInfo>;

void require_sane(const robot::Robot& robot, const std::vector<ros_bridge::AskedJoint>& asked) {
  require(asked.size() == robot.joints.size(), "a command has each joint once");
  for (const robot::Joint& joint : robot.joints) {
    const ros_bridge::AskedJoint& one = asked[joint.number];
    for (const auto& number :
         {one.position_rad, one.velocity_rad_s, one.effort_Nm, one.stiffness_Nm_rad, one.damping_Nms_rad}) {
      require(!number || std::isfinite(*number), "a command that is taken is finite");
    }
    require(one.stiffness_Nm_rad.value_or(0.0) >= 0.0 &&
                one.stiffness_Nm_rad.value_or(0.0) <= ros_bridge::kMostGains * joint.stiffness_Nm_rad,
            "a stiffness that is taken is within its limits");
  }
}

template <class M>
void read_as(Bytes bytes) {
  const auto message = msgs::from_cdr<M>(bytes);
  if (!message) {
    return;
  }
  std::vector<std::uint8_t> written, again;
  msgs::to_cdr(*message, written);
  const auto read = msgs::from_cdr<M>(written);
  require(read.has_value(), "a message that is written is read");
  msgs::to_cdr(*read, again);
  require(written == again, "a message reads back as itself");
  if constexpr (requires { ros_bridge::asked_joints(hyq(), *message); }) {
    if (const auto asked = ros_bridge::asked_joints(hyq(), *message)) {
      require_sane(hyq(), asked.value());
    } else {
      require(asked.error().message.size() < 200, "a refusal is short");
    }
  }
}

template <std::size_t... kPlaces>
void read_as(std::size_t type, Bytes bytes, std::index_sequence<kPlaces...>) {
  ((type == kPlaces ? read_as<std::tuple_element_t<kPlaces, Types>>(bytes) : void()), ...);
}

}  // namespace

void ros_message(Bytes bytes) {
  constexpr std::size_t kTypes = std::tuple_size_v<Types>;
  if (!bytes.empty()) {
    read_as(bytes[0] % kTypes, bytes.subspan(1), std::make_index_sequence<kTypes>());
  }
}

void urdf_file(Bytes bytes) {
  const auto read = urdf::read_urdf_text(std::string(text_of(bytes)), "fuzz.urdf");
  if (!read) {
    require(!read.error().empty(), "a refusal says why");
  }
}

}  // namespace farrier::fuzz
