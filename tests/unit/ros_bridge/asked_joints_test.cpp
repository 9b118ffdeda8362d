#include "tools/ros/asked_joints.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace farrier::ros_bridge {
namespace asked_joints_test {

using ros_messages::control_msgs::DynamicJointState;
using ros_messages::sensor_msgs::JointState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "hyq.yaml").value();
  return robot;
}

std::size_t number_of(const char* joint) { return hyq().find(joint)->number; }

JointState knees(std::vector<double> position, std::vector<double> velocity = {}, std::vector<double> effort = {}) {
  JointState message;
  message.name = {"lf_kfe", "rf_kfe"};
  message.position = std::move(position);
  message.velocity = std::move(velocity);
  message.effort = std::move(effort);
  return message;
}

DynamicJointState knee(std::vector<std::string> interfaces, std::vector<double> values) {
  DynamicJointState message;
  message.joint_names = {"lf_kfe"};
  message.interface_values.push_back({std::move(interfaces), std::move(values)});
  return message;
}

template <class Message>
std::string refusal(const Message& message) {
  const auto asked = asked_joints(hyq(), message);
  return asked ? "" : asked.error().message;
}

TEST(AskedJoints, ArraysOfTheNamesLengthOrNoneAreTakenByName) {
  const auto asked = asked_joints(hyq(), knees({-1.0, -1.1}, {}, {3.0, 4.0})).value();
  EXPECT_EQ(asked[number_of("lf_kfe")].position_rad, -1.0);
  EXPECT_EQ(asked[number_of("rf_kfe")].effort_Nm, 4.0);
  EXPECT_FALSE(asked[number_of("rf_kfe")].velocity_rad_s.has_value());
  EXPECT_TRUE(asked[number_of("lf_haa")].empty());
}

// Newer drivers of the topic-based system pad with NaN where a joint lacks an interface.
TEST(AskedJoints, NanIsNoCommand) {
  const auto asked = asked_joints(hyq(), knees({kNan, -1.1})).value();
  EXPECT_TRUE(asked[number_of("lf_kfe")].empty());
  EXPECT_EQ(asked[number_of("rf_kfe")].position_rad, -1.1);
}

TEST(AskedJoints, ShortArraysUnknownAndRepeatedNamesAndInfiniteNumbersAreRefused) {
  EXPECT_NE(refusal(knees({-1.0})).find("position has 1 numbers for 2 names"), std::string::npos);
  EXPECT_NE(refusal(knees({-1.0, kInfinite})).find("rf_kfe: position is infinite"), std::string::npos);
  JointState unknown = knees({-1.0, -1.0});
  unknown.name[1] = std::string(1'000'000, 'x') + "\n";
  const std::string said = refusal(unknown);
  EXPECT_NE(said.find("has no joint 'xxx"), std::string::npos);
  EXPECT_LT(said.size(), 100u) << "a long name is cut";
  JointState twice = knees({-1.0, -1.0});
  twice.name[1] = twice.name[0];
  EXPECT_EQ(refusal(twice), "joint lf_kfe comes twice");
  EXPECT_EQ(refusal(JointState{}), "it names no joint");
}

TEST(AskedJoints, GainsHaveBothOfTheirNames) {
  for (const auto& names :
       {std::vector<std::string>{"position", "kp", "kd"}, {"position", "proportional", "derivative"}}) {
    const auto asked = asked_joints(hyq(), knee(names, {-1.0, 100.0, 2.0})).value();
    EXPECT_EQ(asked[number_of("lf_kfe")].stiffness_Nm_rad, 100.0);
    EXPECT_EQ(asked[number_of("lf_kfe")].damping_Nms_rad, 2.0);
  }
}

TEST(AskedJoints, GainsOutsideTheirLimitsAndUnknownInterfacesAreRefused) {
  const double most = kMostGains * hyq().find("lf_kfe")->stiffness_Nm_rad;
  EXPECT_EQ(refusal(knee({"position", "kp"}, {-1.0, most})), "");
  EXPECT_NE(refusal(knee({"position", "kp"}, {-1.0, most + 1.0})), "");
  EXPECT_NE(refusal(knee({"position", "kd"}, {-1.0, -0.1})), "");
  EXPECT_NE(refusal(knee({"kp", "proportional"}, {1.0, 1.0})).find("comes twice"), std::string::npos);
  EXPECT_NE(refusal(knee({"integral"}, {1.0})).find("no interface 'integral'"), std::string::npos);
  EXPECT_NE(refusal(knee({"position", "kp"}, {-1.0})).find("1 values for 2 interfaces"), std::string::npos);
  DynamicJointState without_values = knee({}, {});
  without_values.interface_values.clear();
  EXPECT_NE(refusal(without_values).find("0 entries for 1 names"), std::string::npos);
}

}  // namespace asked_joints_test
}  // namespace farrier::ros_bridge
