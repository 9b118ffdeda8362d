#include "run/run_plan.hpp"

#include <cmath>

namespace farrier::run {

std::vector<Member> plan_members(const robot::Robot& robot, Grouping grouping, bool standby) {
  std::vector<Member> members;
  for (const ProgramInfo& program : kPrograms) {
    if (program.program != Program::kJointNode) {
      members.push_back({program.name, program.name, program.number, {}});
    }
  }
  std::uint16_t next = participant::kFirstJointNode;
  const auto group_of = [&](const robot::Joint& joint) {
    switch (grouping) {
      case Grouping::kPerLeg: return robot.plan.legs[static_cast<std::size_t>(joint.leg)].name;
      case Grouping::kPerJoint: return joint.name;
      case Grouping::kOne: return std::string("all");
    }
    return joint.name;
  };
  for (const robot::Joint& joint : robot.joints) {
    const std::string name = "joint_node_" + group_of(joint);
    if (members.back().name != name) {
      members.push_back({name, to_string(Program::kJointNode), next++, {}});
    }
    members.back().joints.push_back(joint.name);
  }
  if (standby) {
    members.push_back({"supervisor_standby", to_string(Program::kSupervisor), next, {}, true});
  }
  return members;
}

std::vector<Member> plan_processes(const robot::Robot& robot, Grouping grouping, bool standby) {
  std::vector<Member> members = plan_members(robot, grouping, standby);
  members.push_back({"launcher", "", static_cast<std::uint16_t>(members.size()), {}});
  return members;
}

bus::Role role_of(const Member& member) noexcept {
  return member.executable.empty() ? bus::Role::kLauncher : participant::role_of(member.number, member.stands_by);
}

Tick ticks_of(double duration_s, const robot::Robot& robot) {
  return static_cast<Tick>(std::llround(duration_s / robot.period_s));
}

}  // namespace farrier::run
