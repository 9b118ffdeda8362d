#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robot/robot.hpp"

namespace farrier::robot {

/// Numbers of all joints, the keys of the topics routed or keyed by joint, in the order of Robot::joints.
std::vector<std::uint16_t> joint_numbers(const Robot& robot);

/// Their names, in the same order.
std::vector<std::string> joint_names(const Robot& robot);

/// Names of the legs that joints belong to, in the order of Robot::joints: the routes of topics routed by leg.
std::vector<std::string> legs_of_joints(const Robot& robot);

/// Numbers of all legs, the keys of gait/phase.
std::vector<std::uint16_t> leg_numbers(const Robot& robot);

}  // namespace farrier::robot
