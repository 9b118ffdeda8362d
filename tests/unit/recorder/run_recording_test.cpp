// Recordings of lock-step runs by one who takes part.

#include "recorder/run_recording.hpp"

#include <gtest/gtest.h>

#include "robot/keys.hpp"
#include "recording/recording_file.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/unit/participant/run.hpp"

namespace farrier::recorder {
namespace run_recording_test {

class RunRecordingTest : public testing::Test {
 protected:
  RunRecordingTest() : member_(run_.join(0, "locomotion")) {
    const std::vector<std::uint16_t> joints = robot::joint_numbers(robot_);
    sensors_ =
        participant::testing::opened(member_->publish<signals::JointSensors>(joints, robot::legs_of_joints(robot_)));
    valves_ = participant::testing::opened(member_->publish<signals::JointValveCommand>(joints));
    measurements_ = participant::testing::opened(member_->publish<signals::JointMeasurement>(joints));
  }

  std::unique_ptr<RunRecording> begin() {
    auto recording = RunRecording::create(path_, {{"robot", "hyq"}}, robot_, *member_.participant);
    EXPECT_TRUE(recording.ok()) << (recording ? "" : recording.error().message);
    sensors_->start();
    valves_->start();
    measurements_->start();
    return std::move(recording).value();
  }

  void publish(Tick tick) {
    for (const robot::Joint& joint : robot_.joints) {
      sensors_->publish({.joint = joint.number, .tick = tick});
      valves_->publish({.joint = joint.number, .tick = tick});
      measurements_->publish({.joint = joint.number, .tick = tick});
    }
    sensors_->flush();
    valves_->flush();
    measurements_->flush();
  }

  const robot::Robot robot_ = robot::load_robot(std::string(FARRIER_ROBOTS) + "hyq.yaml").value();
  const test::ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("run.mcap");
  participant::testing::TestRun run_{1};
  participant::testing::Member member_;
  participant::Out<signals::JointSensors>* sensors_;
  participant::Out<signals::JointValveCommand>* valves_;
  participant::Out<signals::JointMeasurement>* measurements_;
};

TEST_F(RunRecordingTest, HasEverySampleOfEveryJointOnceTheRunIsOver) {
  constexpr Tick kTicks = 100;
  const auto recording = begin();
  for (Tick tick = 0; tick < kTicks; ++tick) {
    publish(tick);
    recording->poll();
    EXPECT_FALSE(recording->has(tick + 1));
  }
  EXPECT_TRUE(recording->has(kTicks / 2)) << "journals come on the way";
  member_->report_health(kTicks, true);
  recording->poll();
  EXPECT_TRUE(recording->has(kTicks));
  const auto finished = recording->finish(kTicks);
  ASSERT_TRUE(finished.ok()) << finished.error().message;
  auto file = recording::RunFileReader::open(path_);
  ASSERT_TRUE(file.ok());
  recording::TopicCounts samples{};
  for (recording::Sample sample; file.value().next(sample);) {
    ++samples[static_cast<std::size_t>(sample.topic)];
  }
  EXPECT_EQ(file.value().ending(), "");
  EXPECT_EQ(file.value().metadata(recording::kRunFacts).at("robot"), "hyq");
  for (const bus::TopicId topic :
       {bus::TopicId::kJointSensors, bus::TopicId::kJointValveCommand, bus::TopicId::kJointMeasurement}) {
    EXPECT_EQ(samples[static_cast<std::size_t>(topic)], robot_.joints.size() * kTicks) << bus::spec(topic).name;
  }
}

TEST_F(RunRecordingTest, SaysWhatWasOverwrittenBecauseNobodyPolled) {
  constexpr Tick kTicks = 20'000;
  const auto recording = begin();
  for (Tick tick = 0; tick < kTicks; ++tick) {
    publish(tick);
    if (tick < kTicks / 2) {
      recording->poll();
    }
  }
  member_->report_health(kTicks, true);
  const auto finished = recording->finish(kTicks);
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().message, "the recording lacks 65232 samples of joint/sensors")
      << "151 of 279 journals that came after the last look, 128 are kept; thirty-six ticks of twelve joints in each";
}

TEST_F(RunRecordingTest, SaysThatTheEndIsMissing) {
  const auto recording = begin();
  publish(0);
  const auto finished = recording->finish(2);
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().message, "the recording ends before the run does");
}

TEST_F(RunRecordingTest, RefusesAFileThatCannotBe) {
  const auto recording = RunRecording::create(scratch_.file("nowhere/run.mcap"), {}, robot_, *member_.participant);
  ASSERT_FALSE(recording.ok());
  EXPECT_NE(recording.error().message.find("nowhere/run.mcap"), std::string::npos) << recording.error().message;
}

}  // namespace run_recording_test
}  // namespace farrier::recorder
