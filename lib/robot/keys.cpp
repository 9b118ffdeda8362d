#include "robot/keys.hpp"

namespace farrier::robot {

std::vector<std::uint16_t> joint_numbers(const Robot& robot) {
  std::vector<std::uint16_t> numbers;
  for (const Joint& joint : robot.joints) {
    numbers.push_back(joint.number);
  }
  return numbers;
}

std::vector<std::string> joint_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    names.push_back(joint.name);
  }
  return names;
}

std::vector<std::string> legs_of_joints(const Robot& robot) {
  std::vector<std::string> legs;
  for (const Joint& joint : robot.joints) {
    legs.push_back(robot.plan.legs[static_cast<std::size_t>(joint.leg)].name);
  }
  return legs;
}

std::vector<std::uint16_t> leg_numbers(const Robot& robot) {
  std::vector<std::uint16_t> numbers;
  for (std::size_t leg = 0; leg < robot.plan.legs.size(); ++leg) {
    numbers.push_back(static_cast<std::uint16_t>(leg));
  }
  return numbers;
}

}  // namespace farrier::robot
