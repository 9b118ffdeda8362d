#include "tools/ros/joint_references.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tools/ros/operator_topics.hpp"

namespace farrier::ros_bridge {
namespace joint_references_test {

using namespace std::chrono_literals;
using ros_messages::control_msgs::DynamicJointState;
using ros_messages::sensor_msgs::JointState;

constexpr Nanoseconds kTimeout = 100ms;
constexpr double kMeasured_rad = -1.0;
const SteadyTime kStart{10s};

class JointReferencesTest : public testing::Test {
 protected:
  JointReferencesTest()
      : robot_(robot::load_robot(FARRIER_ROBOTS "hyq.yaml").value()),
        knee_(*robot_.find("lf_kfe")),
        references_(robot_, kTimeout),
        joints_(robot_.joints.size(), {.angle_rad = kMeasured_rad, .follows = true}) {}

  std::string take(const JointState& message, SteadyTime now, std::uint64_t sender = 1) {
    return references_.take("joint_commands", message, sender, now, joints_);
  }
  JointState knee_at(double position_rad) const {
    JointState message;
    message.name = {knee_.name};
    message.position = {position_rad};
    return message;
  }
  JointReference knee(SteadyTime now) const {
    const auto references = references_.references(now);
    EXPECT_FALSE(references.empty());
    return references.empty() ? JointReference{} : references[knee_.number];
  }

  robot::Robot robot_;
  const robot::Joint& knee_;
  JointReferences references_;
  std::vector<JointNow> joints_;
};

TEST_F(JointReferencesTest, ACommandedPositionHasTheImpedanceOfTheRobotFile) {
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  EXPECT_EQ(knee(kStart).position_rad, -1.1);
  EXPECT_EQ(knee(kStart).stiffness_Nm_rad, knee_.stiffness_Nm_rad);
  EXPECT_EQ(knee(kStart).damping_Nms_rad, knee_.damping_Nms_rad);
}

TEST_F(JointReferencesTest, JointsThatAreNotNamedHoldTheirPlace) {
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  const robot::Joint& other = *robot_.find("rh_hfe");
  joints_[other.number].angle_rad = -1.4;  // it gives way to a load
  EXPECT_EQ(take(knee_at(-1.2), kStart + 10ms), "");
  const JointReference held = references_.references(kStart + 10ms)[other.number];
  EXPECT_EQ(held.position_rad, kMeasured_rad);
  EXPECT_EQ(held.velocity_rad_s, 0.0);
  EXPECT_EQ(held.torque_ff_Nm, 0.0);
  EXPECT_EQ(held.stiffness_Nm_rad, other.stiffness_Nm_rad);
}

TEST_F(JointReferencesTest, ASenderThatIsSilentHasNoReference) {
  EXPECT_TRUE(references_.references(kStart).empty());
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  EXPECT_FALSE(references_.references(kStart + kTimeout).empty());
  EXPECT_TRUE(references_.references(kStart + kTimeout + 1ms).empty());
}

// Drivers send zeros before a controller runs.
TEST_F(JointReferencesTest, AFirstCommandFarFromTheMeasuredAngleIsRefused) {
  EXPECT_NE(take(knee_at(0.0), kStart).find("begin within 0.2 rad of the measured angle"), std::string::npos);
  EXPECT_TRUE(references_.references(kStart).empty());
  EXPECT_EQ(take(knee_at(-1.2), kStart), "");
  EXPECT_EQ(take(knee_at(-1.5), kStart + 10ms), "") << "a later one may be";
  EXPECT_NE(take(knee_at(-1.5), kStart + 20ms + kTimeout), "") << "after a silence it is a first one again";
}

// Arming must not make the robot jump.
TEST_F(JointReferencesTest, WhileAJointDoesNotFollowEveryCommandOfItBeginsNearIt) {
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  joints_[knee_.number] = {.angle_rad = -0.5, .follows = false};
  EXPECT_NE(take(knee_at(-1.1), kStart + 10ms), "");
  EXPECT_EQ(take(knee_at(-0.6), kStart + 20ms), "");
}

TEST_F(JointReferencesTest, AnEffortAloneIsATorqueAndAVelocityAloneIsDamped) {
  JointState effort;
  effort.name = {knee_.name};
  effort.effort = {12.0};
  EXPECT_EQ(take(effort, kStart), "");
  EXPECT_EQ(knee(kStart).torque_ff_Nm, 12.0);
  EXPECT_EQ(knee(kStart).stiffness_Nm_rad, 0.0);
  EXPECT_EQ(knee(kStart).damping_Nms_rad, 0.0);
  JointState velocity;
  velocity.name = {knee_.name};
  velocity.velocity = {0.5};
  EXPECT_EQ(take(velocity, kStart + 10ms), "");
  EXPECT_EQ(knee(kStart + 10ms).velocity_rad_s, 0.5);
  EXPECT_EQ(knee(kStart + 10ms).stiffness_Nm_rad, 0.0);
  EXPECT_EQ(knee(kStart + 10ms).damping_Nms_rad, knee_.damping_Nms_rad);
  EXPECT_NE(take(knee_at(-1.5), kStart + 20ms), "") << "its first position must be near";
}

TEST_F(JointReferencesTest, ImpedanceCommandsBringTheirGains) {
  DynamicJointState message;
  message.joint_names = {knee_.name};
  message.interface_values.push_back({{"position", "velocity", "effort", "kp", "kd"}, {-1.1, 0.5, 7.0, 90.0, 3.0}});
  EXPECT_EQ(references_.take("impedance_commands", message, 1, kStart, joints_), "");
  EXPECT_EQ(knee(kStart).stiffness_Nm_rad, 90.0);
  EXPECT_EQ(knee(kStart).damping_Nms_rad, 3.0);
  EXPECT_EQ(knee(kStart).torque_ff_Nm, 7.0);
}

TEST_F(JointReferencesTest, ASecondSenderChangesNothing) {
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  EXPECT_NE(take(knee_at(-0.9), kStart + 50ms, 2), "");
  EXPECT_EQ(knee(kStart + 50ms).position_rad, -1.1);
  EXPECT_EQ(take(knee_at(-0.9), kStart + kTimeout + 1ms, 2), "");
}

TEST_F(JointReferencesTest, ARefusedMessageChangesNothing) {
  EXPECT_EQ(take(knee_at(-1.1), kStart), "");
  JointState bad = knee_at(-1.2);
  bad.velocity = {0.1, 0.2};
  EXPECT_NE(take(bad, kStart + kTimeout), "");
  EXPECT_EQ(knee(kStart + kTimeout).position_rad, -1.1);
  EXPECT_TRUE(references_.references(kStart + kTimeout + 1ms).empty()) << "nor does it keep the sender";
}

TEST_F(JointReferencesTest, WithoutSensorsThereIsNoReference) {
  joints_[knee_.number].angle_rad.reset();
  EXPECT_NE(take(knee_at(-1.0), kStart).find("no sensors of lf_kfe"), std::string::npos);
}

TEST(OperatorPulses, AnySenderStopsAndARepeatedArmDoesNotUndoIt) {
  OperatorPulses pulses;
  EXPECT_TRUE(pulses.arm(true, kStart));
  EXPECT_FALSE(pulses.arm(true, kStart + 100ms)) << "a sender that repeats it arms once";
  EXPECT_TRUE(pulses.stop(true, kStart + 200ms));
  EXPECT_FALSE(pulses.stop(false, kStart + 300ms));
  EXPECT_FALSE(pulses.arm(true, kStart + 900ms));
  EXPECT_FALSE(pulses.arm(true, kStart + 1800ms)) << "it has been repeating";
  EXPECT_FALSE(pulses.arm(false, kStart + 3s));
  EXPECT_TRUE(pulses.arm(true, kStart + 3100ms));
}

}  // namespace joint_references_test
}  // namespace farrier::ros_bridge
