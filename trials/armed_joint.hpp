#pragma once

#include "core/result.hpp"
#include "joint_node/joint_node.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// A joint's node, armed from tick 0 on, with the gains and the physics that the file of `known` gives for its swing load.
/// The node itself is of the joint `own`. Refuses a joint for which there are no gains, with the reason.
Result<joint_node::JointNode> armed_joint(const robot::Joint& own, const robot::Joint& known, double period_s,
                                          int delay_ticks);

}  // namespace farrier::trials
