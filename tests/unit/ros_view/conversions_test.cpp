#include "ros_view/conversions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/fault.hpp"
#include "ros_view/topics.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::ros_view {
namespace conversions_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class OfHyq : public testing::Test {
 protected:
  OfHyq() : samples_(hyq_.joints.size()) {
    for (const robot::Joint& joint : hyq_.joints) {
      signals::JointSensors& sensors = samples_[joint.number].sensors;
      sensors.joint = joint.number;
      sensors.tick = 5;
      sensors.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
      sensors.velocity_m_s_or_rad_s = 0.1;
      sensors.force_N_or_Nm = 200.0;
    }
  }

  const robot::Robot hyq_ = robot::load_shipped("hyq");
  std::vector<JointSamples> samples_;
};

TEST_F(OfHyq, JointStatesAreAnglesVelocitiesAndTorquesBehindTheLinkage) {
  const auto message = joint_state(hyq_, samples_, {.sec = 1, .nanosec = 2});
  ASSERT_EQ(message.name.size(), 12u);
  ASSERT_EQ(message.position.size(), 12u);
  ASSERT_EQ(message.velocity.size(), 12u);
  ASSERT_EQ(message.effort.size(), 12u);
  for (const robot::Joint& joint : hyq_.joints) {
    const double lever = joint.linkage.lever(joint.home_angle_rad);
    EXPECT_EQ(message.name[joint.number], joint.name);
    EXPECT_NEAR(message.position[joint.number], joint.home_angle_rad, 1e-9);
    EXPECT_NEAR(message.velocity[joint.number] * lever, 0.1, 1e-9);
    EXPECT_NEAR(message.effort[joint.number], 200.0 * lever, 1e-6) << "powers agree on both sides";
  }
}

// Readers of ROS index position by the place of the name, and take no number that is not finite.
TEST_F(OfHyq, AJointThatIsNotHeardOrNotFiniteIsLeftOut) {
  samples_[0].sensors.tick = kNoTick;
  samples_[1].sensors.velocity_m_s_or_rad_s = kNan;
  const auto message = joint_state(hyq_, samples_, {});
  EXPECT_EQ(message.name.size(), 10u);
  EXPECT_EQ(message.name.front(), "lf_kfe");
  EXPECT_EQ(message.position.size(), message.name.size());
  EXPECT_EQ(dynamic_joint_state(hyq_, samples_, {}).joint_names.size(), 10u);
}

TEST_F(OfHyq, DynamicJointStatesNameTheActuatorsForceAndFaults) {
  samples_[3].summary.tick = 5;
  samples_[3].summary.faults = 3;
  const auto message = dynamic_joint_state(hyq_, samples_, {});
  const auto& values = message.interface_values[3];
  EXPECT_EQ(values.interface_names,
            (std::vector<std::string>{"position", "velocity", "effort", "force", "force_reference", "valve_current",
                                      "gain_generation", "faults"}));
  EXPECT_EQ(values.values.size(), values.interface_names.size());
  EXPECT_EQ(values.values.back(), 3.0);
  EXPECT_EQ(message.interface_values[0].interface_names.size(), 4u) << "no summary yet";
}

TEST_F(OfHyq, DiagnosticsGiveFaultsTheirLevels) {
  monitor::Frame frame;
  frame.joints.resize(12);
  frame.joints[0].faults = static_cast<std::uint32_t>(Fault::kTripped);
  frame.joints[1].age_s = std::numeric_limits<double>::infinity();
  const auto message = diagnostics(hyq_, frame, {});
  ASSERT_EQ(message.status.size(), 13u);
  EXPECT_EQ(message.status[0].level, std::byte{3}) << "no mode heard";
  EXPECT_EQ(message.status[1].name, "hyq: joint lf_haa");
  EXPECT_EQ(message.status[1].level, std::byte{2});
  EXPECT_EQ(message.status[1].message, "tripped");
  EXPECT_EQ(message.status[2].level, std::byte{3});
  EXPECT_EQ(message.status[3].level, std::byte{0});
}

TEST(Imu, AttitudeCountsAsNotMeasured) {
  signals::BodyImu reading;
  reading.specific_force_m_s2 = {0.0, 0.0, 9.81};
  const auto message = imu(reading, {});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->orientation_covariance[0], -1.0);
  EXPECT_EQ(message->linear_acceleration.z, 9.81);
  EXPECT_EQ(message->header.frame_id, "base_link");
  reading.angular_velocity_rad_s[1] = kNan;
  EXPECT_FALSE(imu(reading, {}).has_value());
}

// A robot that has turned by 90 degrees to the left and moves along the world's y axis moves forward.
TEST(Odometry, TheTwistIsInTheAxesOfTheBase) {
  signals::BodyState state;
  state.attitude = {std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};
  state.velocity_m_s = {0.0, 0.4, 0.0};
  state.position_m = {1.0, 2.0, 0.5};
  const auto message = odometry(state, {});
  ASSERT_TRUE(message.has_value());
  EXPECT_NEAR(message->twist.twist.linear.x, 0.4, 1e-12);
  EXPECT_NEAR(message->twist.twist.linear.y, 0.0, 1e-12);
  EXPECT_NEAR(message->pose.pose.orientation.z, std::sqrt(0.5), 1e-12);
  const auto tf = transform(*message);
  ASSERT_EQ(tf.transforms.size(), 1u);
  EXPECT_EQ(tf.transforms[0].header.frame_id, "odom");
  EXPECT_EQ(tf.transforms[0].child_frame_id, "base_link");
  EXPECT_EQ(tf.transforms[0].transform.translation.y, 2.0);
}

// A vertical force of the ground on a robot that stands upright: the foot's frame is pitched as its lower leg is.
TEST_F(OfHyq, TheWrenchOfAFootIsInTheFramesOfTheFoot) {
  signals::BodyState state;
  state.attitude = {1.0, 0.0, 0.0, 0.0};
  state.felt_force_N[3 * 1 + 2] = 100.0;
  const std::string leg = hyq_.body->legs[1].name;
  double pitch_rad = 0.0;
  for (const robot::Joint& joint : hyq_.joints) {
    if (joint.leg == 1) {
      const double angle_rad = joint.index_in_leg == 0 ? 0.0 : joint.home_angle_rad;
      samples_[joint.number].sensors.position_m_or_rad = joint.linkage.position(angle_rad);
      pitch_rad += angle_rad * hyq_.body->legs[1].links[static_cast<std::size_t>(joint.index_in_leg)].axis.y();
    }
  }
  const auto message = foot_wrench(hyq_, 1, state, samples_, {.sec = 7, .nanosec = 0});
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->header.frame_id, leg + "_foot");
  EXPECT_EQ(foot_wrench_topic(leg), leg + "_foot/wrench");
  EXPECT_NEAR(message->wrench.force.x, -100.0 * std::sin(pitch_rad), 1e-6);
  EXPECT_NEAR(message->wrench.force.y, 0.0, 1e-6);
  EXPECT_NEAR(message->wrench.force.z, 100.0 * std::cos(pitch_rad), 1e-6);
  EXPECT_GT(std::abs(pitch_rad), 0.1) << "or the test says little";
  state.felt_force_N[3] = kNan;
  EXPECT_FALSE(foot_wrench(hyq_, 1, state, samples_, {}).has_value());
  EXPECT_TRUE(foot_wrench(hyq_, 0, state, samples_, {}).has_value());
  samples_[0].sensors.tick = kNoTick;
  EXPECT_FALSE(foot_wrench(hyq_, 0, state, samples_, {}).has_value()) << "a joint of the leg is not heard";
}

TEST(Stamp, CountsSecondsAndNanoseconds) {
  EXPECT_EQ(time_of(1'500'000'002), (Time{.sec = 1, .nanosec = 500'000'002}));
  EXPECT_EQ(time_of(-1), (Time{}));
}

TEST(Log, LevelsAreThoseOfRos) {
  monitor::EventFrame event;
  event.severity = signals::Severity::kWarning;
  event.who = "joint_node lf";
  event.joint = "lf_kfe";
  event.text = "tripped";
  const auto line = log_line(event, "farrier", {});
  EXPECT_EQ(line.level, 30);
  EXPECT_EQ(line.name, "farrier.joint_node lf");
  EXPECT_EQ(line.msg, "lf_kfe: tripped");
}

}  // namespace conversions_test
}  // namespace farrier::ros_view
