#include "tools/ros/joint_references.hpp"

#include <cmath>

#include "config/visitor.hpp"

namespace farrier::ros_bridge {
namespace {

/// The reference of a joint that is commanded, from what it is asked.
JointReference commanded(const robot::Joint& joint, const AskedJoint& asked, double angle_rad) {
  const bool moves = asked.position_rad || asked.velocity_rad_s;
  return {.position_rad = asked.position_rad.value_or(angle_rad),
          .velocity_rad_s = asked.velocity_rad_s.value_or(0.0),
          .torque_ff_Nm = asked.effort_Nm.value_or(0.0),
          .stiffness_Nm_rad = asked.position_rad ? asked.stiffness_Nm_rad.value_or(joint.stiffness_Nm_rad) : 0.0,
          .damping_Nms_rad = asked.damping_Nms_rad.value_or(moves ? joint.damping_Nms_rad : 0.0)};
}

std::string too_far(const robot::Joint& joint, double asked_rad, double angle_rad) {
  return joint.name + " is asked for " + config::number_text(asked_rad) + " rad and is at " +
         config::number_text(angle_rad) + ": begin within " + config::number_text(JointReferences::kNear_rad) +
         " rad of the measured angle";
}

}  // namespace

JointReferences::JointReferences(const robot::Robot& robot, Nanoseconds timeout)
    : robot_(robot), sender_(timeout), references_(robot.joints.size()), positioned_(robot.joints.size(), false) {}

std::string JointReferences::apply(const std::vector<AskedJoint>& asked, std::uint64_t sender, SteadyTime now,
                                   std::span<const JointNow> joints) {
  const bool begins = sender_.silent(now);
  std::vector<JointReference> next = references_;
  std::vector<bool> positioned = positioned_;
  for (const robot::Joint& joint : robot_.joints) {
    const std::size_t at = joint.number;
    const AskedJoint& wanted = asked[at];
    if (!joints[at].angle_rad) {
      return "no sensors of " + joint.name + " have come yet";
    }
    const double angle_rad = *joints[at].angle_rad;
    const bool continues = !begins && positioned_[at] && joints[at].follows;
    if (wanted.empty()) {
      AskedJoint holds = wanted;
      holds.position_rad = continues ? references_[at].position_rad : angle_rad;
      next[at] = commanded(joint, holds, angle_rad);
      positioned[at] = true;
      continue;
    }
    if (wanted.position_rad && !continues && !(std::abs(*wanted.position_rad - angle_rad) <= kNear_rad)) {
      return too_far(joint, *wanted.position_rad, angle_rad);
    }
    next[at] = commanded(joint, wanted, angle_rad);
    positioned[at] = wanted.position_rad.has_value();
  }
  references_ = std::move(next);
  positioned_ = std::move(positioned);
  sender_.heard(sender, now);
  return "";
}

std::span<const JointReference> JointReferences::references(SteadyTime now) const {
  return sender_.silent(now) ? std::span<const JointReference>() : std::span(references_);
}

}  // namespace farrier::ros_bridge
