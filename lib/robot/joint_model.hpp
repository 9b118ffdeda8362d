#pragma once

#include "control/model/discretise.hpp"
#include "robot/robot.hpp"

namespace farrier::robot {

/// Sampled model of a joint under a bench load at its home pose, the valve just opening to extend, which is the sign
/// the thesis designs for and the one with the higher valve gain. An electric joint has one model for all poses.
control::DiscreteModel model_of(const Joint& joint, const plant::LoadParams& load, double period_s);

}  // namespace farrier::robot
