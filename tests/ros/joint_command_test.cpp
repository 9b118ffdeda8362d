// farrier ros --joint-commands in a run on the bench: writers of both vendors command joints, stop and arm the robot, and
// send what no robot should obey.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "tests/ros/robot_with_node.hpp"
#include "tests/ros/sender.hpp"
#include "tests/ros/user_node.hpp"

namespace farrier::test {
namespace joint_command_test {

using namespace std::chrono_literals;
using ros_messages::control_msgs::DynamicJointState;
using ros_messages::sensor_msgs::JointState;
using ros_messages::std_msgs::Bool;

constexpr int kRosDomain = 65;
constexpr const char* kVendor = "cyclone";
constexpr const char* kJoint = "lf_kfe";
constexpr const char* kStatus = "hyq: joint lf_kfe";
constexpr double kStep_rad = 0.12;
constexpr double kStays_rad = 0.06;  // it gives way to its load for a while
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

JointState positions(std::vector<std::string> names, std::vector<double> position_rad) {
  JointState message;
  message.name = std::move(names);
  message.position = std::move(position_rad);
  return message;
}

class JointCommands : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ = std::make_unique<RobotWithNode>();
    robot_->start({"--world", "bench", "--gait", "stand", "--clock", "realtime", "--no-locomotion", "--no-comparison",
                   "--start-limit", "0"},
                  {"--ros-domain", std::to_string(kRosDomain), "--commands", "--joint-commands", "--allow-arm",
                   "--command-timeout", "1"},
                  "commands are of joints, taken from any node");
  }
  static void TearDownTestSuite() { robot_.reset(); }

  void SetUp() override {
    ASSERT_TRUE(user_.until([&] { return user_.angle_rad(kJoint) && joints_->matched_readers() > 0; }))
        << robot_->ros().output();
    start_rad_ = *user_.angle_rad(kJoint);
  }

  /// True if the joint does what it is asked.
  bool tracks() const {
    const std::string status = user_.status(kStatus);
    const auto says = [&](const char* fault) { return status.find(fault) != std::string::npos; };
    return !status.empty() && !says("disarmed") && !says("tripped") && !says("stale") && !says("silent");
  }

  /// Calls `hold` until the joint tracks, which takes an `arm` after a trip. A joint that is at null is held by its oil.
  template <class Hold>
  void begin(Hold&& hold) {
    const auto arm = sender_of<Bool>(kVendor, kRosDomain, "/hyq/arm");
    int turns = 0;
    user_.forget();
    ASSERT_TRUE(user_.until([&] { return tracks(); },
                            [&] {
                              hold();
                              if (++turns % 110 == 0) {  // a pulse, at most one a second
                                arm->send(Bool{.data = true});
                              }
                            }))
        << user_.status(kStatus) << "\n"
        << robot_->ros().output();
    user_.until([&] { return ++turns % 50 == 0; }, hold);  // settles under its load
    settled_rad_ = *user_.angle_rad(kJoint);
    user_.forget();
  }
  void hold() { joints_->send(positions({kJoint}, {start_rad_})); }

  /// Sends `hold` beside what `act` does, until /rosout says `text`. The joint stays where it is.
  template <class Act>
  void is_refused_with(const std::string& text, Act&& act) {
    EXPECT_TRUE(user_.until([&] { return user_.was_told(text); },
                            [&] {
                              hold();
                              act();
                            }))
        << text << "\n"
        << robot_->ros().output();
    EXPECT_NEAR(*user_.angle_rad(kJoint), settled_rad_, kStays_rad) << text;
  }

  UserNode user_{kRosDomain};
  std::unique_ptr<Sender> joints_ = sender_of<JointState>(kVendor, kRosDomain, "/hyq/joint_commands");
  double start_rad_ = 0.0, settled_rad_ = 0.0;

  static inline std::unique_ptr<RobotWithNode> robot_;
};

// The bench loads its joints with a constant torque: a step of the reference is a step of the angle.
TEST_F(JointCommands, AJointFollowsImpedanceCommandsOfBothVendorsAndTripsWhenTheyCease) {
  for (const std::string& vendor : sender_vendors()) {
    const auto impedances = sender_of<DynamicJointState>(vendor, kRosDomain, "/hyq/impedance_commands");
    double target_rad = *user_.angle_rad(kJoint);
    const auto send = [&] {
      DynamicJointState message;
      message.joint_names = {kJoint};
      message.interface_values.push_back(
          {{"position", "velocity", "effort", "kp", "kd"}, {target_rad, 0.0, 0.0, 400.0, 10.0}});
      impedances->send(message);
    };
    begin(send);
    target_rad += kStep_rad;
    EXPECT_TRUE(user_.until([&] { return *user_.angle_rad(kJoint) - settled_rad_ > 0.7 * kStep_rad; }, send))
        << vendor << ": " << *user_.angle_rad(kJoint) << " after " << settled_rad_;
    user_.forget();
    EXPECT_TRUE(user_.until([&] { return user_.was_told("joint commands are silent"); })) << vendor;
    EXPECT_TRUE(user_.until([&] { return user_.was_told("tripped"); })) << vendor << "\n" << robot_->ros().output();
  }
}

TEST_F(JointCommands, CommandsThatNoRobotShouldObeyChangeNothing) {
  // A first command of zeros, as a driver sends them before its controller runs.
  EXPECT_TRUE(user_.until([&] { return user_.was_told("begin within 0.2 rad"); },
                          [&] { joints_->send(positions({kJoint}, {0.0})); }));
  begin([this] { hold(); });
  const auto send = [&](const JointState& message) { return [&, message] { joints_->send(message); }; };
  is_refused_with("position has 1 numbers for 2 names", send(positions({kJoint, "rf_kfe"}, {start_rad_ + 0.5})));
  is_refused_with("has no joint 'xxx", send(positions({std::string(1'000'000, 'x')}, {0.5})));
  is_refused_with("position is infinite", send(positions({kJoint}, {std::numeric_limits<double>::infinity()})));
  const auto second = sender_of<JointState>(kVendor, kRosDomain, "/hyq/joint_commands");
  is_refused_with("of a second sender", [&] { second->send(positions({kJoint}, {start_rad_ + 0.15})); });
  // NaN commands nothing: the joint holds its place.
  int turns = 0;
  EXPECT_TRUE(user_.until([&] { return turns > 30 && tracks(); },
                          [&] {
                            joints_->send(positions({kJoint}, {kNan}));
                            ++turns;
                          }))
      << user_.status(kStatus);
  EXPECT_NEAR(*user_.angle_rad(kJoint), settled_rad_, kStays_rad);
}

TEST_F(JointCommands, AnyNodeStopsTheRobotAndARepeatedArmDoesNotUndoIt) {
  begin([this] { hold(); });
  const auto stop = sender_of<Bool>(kVendor, kRosDomain, "/hyq/stop", false);
  const auto arm = sender_of<Bool>(kVendor, kRosDomain, "/hyq/arm");
  ASSERT_TRUE(user_.until([&] { return user_.was_told("the robot is stopped"); },
                          [&] {
                            hold();
                            stop->send(Bool{.data = true});
                          }))
      << robot_->ros().output();
  user_.forget();
  int turns = 0;
  user_.until([&] { return turns > 150 || user_.was_told("the robot is armed"); },
              [&] {
                hold();
                arm->send(Bool{.data = true});
                stop->send(Bool{.data = ++turns % 50 == 0});
              });
  EXPECT_FALSE(user_.was_told("the robot is armed"));
}

}  // namespace joint_command_test
}  // namespace farrier::test
