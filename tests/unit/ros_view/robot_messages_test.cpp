#include "ros_view/robot_messages.hpp"

#include <gtest/gtest.h>

#include <map>

#include "ros_messages/cdr.hpp"
#include "tests/unit/robot/test_files.hpp"

namespace farrier::ros_view {
namespace robot_messages_test {

constexpr std::uint64_t kBegin_ns = 1'700'000'000'000'000'000;
constexpr std::uint64_t kTick_ns = 1'000'000;

class Messages : public testing::Test {
 protected:
  /// One second of sensors and body, published at every tick.
  void run_second() {
    for (Tick tick = 0; tick < 1000; ++tick) {
      const std::uint64_t now_ns = kBegin_ns + static_cast<std::uint64_t>(tick) * kTick_ns;
      for (const robot::Joint& joint : hyq_.joints) {
        signals::JointSensors sensors;
        sensors.joint = joint.number;
        sensors.tick = tick;
        sensors.position_m_or_rad = joint.linkage.position(joint.home_angle_rad);
        messages_.take(sensors, now_ns);
      }
      signals::BodyState state;
      state.tick = tick;
      state.attitude = {1.0, 0.0, 0.0, 0.0};
      messages_.take(state, now_ns);
      messages_.take(signals::BodyImu{}, now_ns);
      publish(now_ns);
    }
  }
  void publish(std::uint64_t now_ns) {
    messages_.publish(now_ns, [this](std::size_t topic, std::uint64_t, std::span<const std::uint8_t> cdr) {
      ++counts_[messages_.topics()[topic].name];
      newest_[messages_.topics()[topic].name].assign(cdr.begin(), cdr.end());
    });
  }

  const robot::Robot hyq_ = robot::load_shipped("hyq");
  RobotMessages messages_{hyq_, {.ros_namespace = "/hyq", .description = "<robot/>"}};
  std::map<std::string, int> counts_;
  std::map<std::string, std::vector<std::uint8_t>> newest_;
};

TEST_F(Messages, ComeAtTheRatesOfTheirTopics) {
  run_second();
  EXPECT_EQ(counts_.at("/hyq/joint_states"), 100);
  EXPECT_EQ(counts_.at("/hyq/dynamic_joint_states"), 50);
  EXPECT_EQ(counts_.at("/hyq/imu"), 100);
  EXPECT_EQ(counts_.at("/hyq/odom"), 100);
  EXPECT_EQ(counts_.at("/tf"), 50);
  EXPECT_EQ(counts_.at("/hyq/lf_foot/wrench"), 100);
  EXPECT_FALSE(counts_.contains("/diagnostics")) << "no frame has come";
  const auto joints = ros_messages::from_cdr<sensor_msgs::JointState>(newest_.at("/hyq/joint_states"));
  ASSERT_TRUE(joints.has_value());
  EXPECT_EQ(joints->name.size(), 12u);
  EXPECT_EQ(joints->header.stamp, time_of(static_cast<std::int64_t>(kBegin_ns + 990 * kTick_ns)));
}

TEST_F(Messages, SamplesThatHaveBeenHandedOnAreNotHandedOnAgain) {
  run_second();
  counts_.clear();
  publish(kBegin_ns + 5'000'000'000);
  EXPECT_EQ(counts_.at("/hyq/joint_states"), 1) << "those of the last nine ticks";
  counts_.clear();
  publish(kBegin_ns + 6'000'000'000);
  EXPECT_TRUE(counts_.empty());
}

TEST_F(Messages, AFrameGivesDiagnosticsAndItsEventsLinesOfTheLog) {
  monitor::Frame frame;
  frame.joints.resize(12);
  frame.events.resize(2);
  messages_.take(frame, kBegin_ns);
  publish(kBegin_ns);
  EXPECT_EQ(counts_.at("/rosout"), 2);
  EXPECT_EQ(counts_.at("/diagnostics"), 1);
  publish(kBegin_ns + 1);
  EXPECT_EQ(counts_.at("/rosout"), 2);
}

TEST_F(Messages, TheDescriptionIsAMessageOfAKeptTopic) {
  const auto text = ros_messages::from_cdr<ros_messages::std_msgs::String>(messages_.description_cdr());
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(text->data, "<robot/>");
  const Topic& topic = messages_.topics()[messages_.description_topic()];
  EXPECT_EQ(topic.name, "/hyq/robot_description");
  EXPECT_TRUE(topic.kept);
  EXPECT_EQ(topic.definition, "string data\n");
}

TEST_F(Messages, SamplesOfJointsThatTheRobotDoesNotHaveAreLeftOut) {
  signals::JointSensors sensors;
  sensors.joint = 12;
  messages_.take(sensors, kBegin_ns);
  signals::JointSummary summary;
  summary.joint = 500;
  messages_.take(summary);
  publish(kBegin_ns);
  EXPECT_TRUE(counts_.empty());
}

}  // namespace robot_messages_test
}  // namespace farrier::ros_view
