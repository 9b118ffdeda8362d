#pragma once

#include <string>
#include <vector>

#include "participant/participant.hpp"
#include "robot/robot.hpp"

namespace farrier::lab {

/// How joints are grouped into joint_node processes.
enum class Grouping { kPerLeg, kPerJoint, kOne };

/// One participant of a run.
struct Member {
  std::string name;                 ///< "sim_bridge", "joint_node_lf", ...
  std::string executable;           ///< of its process; empty: the launcher itself
  std::uint16_t number = 0;
  std::vector<std::string> joints;  ///< joint nodes: those they host
};

/// Everybody who takes part, in the order of their numbers.
std::vector<Member> plan_members(const robot::Robot& robot, Grouping grouping);

/// Length of a run in ticks.
Tick ticks_of(double duration_s, const robot::Robot& robot);

}  // namespace farrier::lab
