#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "robot/robot.hpp"

namespace farrier::ros_bridge {
namespace ros2_control_example_test {

std::size_t times(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Ros2ControlExample, HasTheJointsOfHyqAndTheTopicsOfTheNode) {
  std::ifstream file(FARRIER_ROBOTS "../ros2/hyq.ros2_control.xml");
  const std::string tag{std::istreambuf_iterator<char>(file), {}};
  const auto robot = robot::load_robot(FARRIER_ROBOTS "hyq.yaml");
  ASSERT_TRUE(robot.ok());
  EXPECT_EQ(times(tag, "<joint name="), robot.value().joints.size());
  for (const robot::Joint& joint : robot.value().joints) {
    EXPECT_EQ(times(tag, "<joint name=\"" + joint.name + "\">"), 1u) << joint.name;
  }
  EXPECT_EQ(times(tag, "\"joint_states_topic\">/hyq/joint_states<"), 1u);
  EXPECT_EQ(times(tag, "\"joint_commands_topic\">/hyq/joint_commands<"), 1u);
  EXPECT_EQ(times(tag, "\"trigger_joint_command_threshold\">-1<"), 1u) << "else it falls silent at rest";
}

}  // namespace ros2_control_example_test
}  // namespace farrier::ros_bridge
