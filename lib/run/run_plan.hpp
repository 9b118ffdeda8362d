#pragma once

#include <string>
#include <vector>

#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::run {

/// Grouping of joints into joint_node processes.
enum class Grouping { kPerLeg, kPerJoint, kOne };

/// One participant of a run.
struct Member {
  std::string name;                 ///< "sim_bridge", "joint_node_lf", ...
  std::string executable;           ///< of its process; empty: it is the launcher
  std::uint16_t number = 0;
  std::vector<std::string> joints;  ///< joint nodes: those they host
  bool stands_by = false;           ///< a supervisor that leads when the other has fallen silent
};

/// All participants, in the order of their numbers; with `standby`, a second supervisor as the last.
std::vector<Member> plan_members(const robot::Robot& robot, Grouping grouping, bool standby = false);

/// The same as processes, and as the last the launcher, which starts them, greets them and listens.
std::vector<Member> plan_processes(const robot::Robot& robot, Grouping grouping, bool standby);

/// The rights that a member needs under DDS Security.
bus::Role role_of(const Member& member) noexcept;

/// Length of a run in ticks.
Tick ticks_of(double duration_s, const robot::Robot& robot);

}  // namespace farrier::run
