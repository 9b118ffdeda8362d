#pragma once

#include "control/design/closed_loop.hpp"
#include "robot/robot.hpp"

namespace farrier::supervisor {

/// LQR of a joint for a bench load, in the form and with the weights of the robot file, for a loop with
/// `delay_ticks` of delay. Refuses with the joint's name and the design's reason. Behind the sensors' filters it refuses
/// an unstable loop of kind lqr, and a law of another kind that does not settle on this load (LawCheck).
Result<control::Gains> design_joint(const robot::Joint& joint, const plant::LoadParams& load, double period_s,
                                    int delay_ticks);

}  // namespace farrier::supervisor
