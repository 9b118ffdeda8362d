#pragma once

#include <memory>

#include "core/result.hpp"
#include "estimation/estimator.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Scales, noise and times that every estimator of the joint has.
estimation::JointScales estimator_scales(const Joint& joint, double period_s, int loop_delay_ticks);

/// The estimator the joint's parameters ask for, with the only list of methods. It starts from the joint's swing load in
/// both phases; a command acts `loop_delay_ticks` after the sample it answers. Refuses settings out of range, and a joint
/// the method cannot serve, naming the joint and the condition.
Result<std::unique_ptr<estimation::Estimator>> make_estimator(const Joint& joint, double period_s,
                                                              int loop_delay_ticks);

}  // namespace farrier::robot
