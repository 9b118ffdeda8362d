// Recordings of what crosses the bus.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "diagnosis/recording.hpp"
#include "lab/recorder.hpp"
#include "robot/keys.hpp"
#include "tests/unit/participant_run.hpp"

namespace farrier::lab {
namespace {

namespace fs = std::filesystem;

class RecorderTest : public testing::Test {
 protected:
  RecorderTest() : directory_(fs::temp_directory_path() / ("farrier_recorder_" + std::to_string(::getpid()))) {
    fs::create_directories(directory_);
  }
  ~RecorderTest() override { fs::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }
  static std::string bytes(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  JointRecording recording_of(const char* joint, const std::string& name) const {
    return JointRecording::create(path(name), robot_, *robot_.find(joint)).value();
  }

  robot::Robot robot_ = robot::load_robot(std::string(FARRIER_ROBOTS) + "hyq.yaml").value();

 private:
  fs::path directory_;
};

signals::JointSensors sensors(Tick tick, std::uint16_t joint = 0) {
  signals::JointSensors sample;
  sample.joint = joint;
  sample.tick = tick;
  sample.position_m_or_rad = 0.04 + 0.001 * std::sin(0.01 * static_cast<double>(tick));
  sample.velocity_m_s_or_rad_s = 0.01 * std::cos(0.01 * static_cast<double>(tick));
  sample.force_N_or_Nm = 100.0 / 3.0 + static_cast<double>(tick);
  return sample;
}

signals::JointValveCommand valve(Tick tick, signals::Phase phase = signals::Phase::kSwing, std::uint16_t joint = 0) {
  signals::JointValveCommand command;
  command.joint = joint;
  command.tick = tick;
  command.valve_current_A = 1e-5 * static_cast<double>(tick + 1);
  command.phase = static_cast<std::uint8_t>(phase);
  return command;
}

TEST_F(RecorderTest, WritesWhatDiagnoseReadsToTheLastBit) {
  constexpr Tick kTicks = 1200;
  JointRecording recording = recording_of("lf_kfe", "knee.csv");
  for (Tick tick = 0; tick < kTicks; ++tick) {
    recording.take(sensors(tick));
    recording.take(valve(tick, tick < 600 ? signals::Phase::kStance : signals::Phase::kSwing));
  }
  ASSERT_TRUE(recording.finish(kTicks).ok());
  const auto read = diagnosis::read_recording(path("knee.csv"));
  ASSERT_TRUE(read.ok()) << diagnosis::to_string(read.error().findings, "knee.csv");
  const diagnosis::Recording& r = read.value();
  EXPECT_EQ(r.coordinates, diagnosis::Coordinates::kLinear);
  EXPECT_FALSE(r.velocity_derived);
  EXPECT_TRUE(r.remarks.empty());
  EXPECT_DOUBLE_EQ(r.period_s, robot_.period_s);
  ASSERT_EQ(r.time_s.size(), static_cast<std::size_t>(kTicks));
  for (std::size_t k = 0; k < r.time_s.size(); ++k) {
    const auto tick = static_cast<Tick>(k);
    EXPECT_EQ(r.position[k], sensors(tick).position_m_or_rad);
    EXPECT_EQ(r.velocity[k], sensors(tick).velocity_m_s_or_rad_s);
    EXPECT_EQ(r.force[k], sensors(tick).force_N_or_Nm);
    EXPECT_EQ(r.valve_current_A[k], valve(tick).valve_current_A);
    EXPECT_EQ(r.swing[k], tick < 600 ? 0 : 1);
  }
}

TEST_F(RecorderTest, NamesTheColumnsOfAMotorAfterItsCoordinates) {
  JointRecording recording = recording_of("lf_haa", "hip.csv");
  ASSERT_TRUE(recording.finish(0).ok());
  EXPECT_EQ(bytes(path("hip.csv")), "time_s,valve_current_A,angle_rad,velocity_rad_s,torque_Nm,swing\n");
}

TEST_F(RecorderTest, GivesARowTheCurrentThatActsFromItOn) {
  robot_.loop_delay_lockstep = 2;
  JointRecording recording = recording_of("lf_kfe", "late.csv");
  for (Tick tick = 0; tick < 3; ++tick) {
    recording.take(valve(tick));  // whichever topic is first
    recording.take(sensors(tick));
  }
  ASSERT_TRUE(recording.finish(3).ok());
  std::istringstream lines(bytes(path("late.csv")));
  std::string line;
  std::getline(lines, line);
  for (const char* begin : {"0,0,", "0.001,0,", "0.002,1e-05,"}) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line.substr(0, std::string(begin).size()), begin);
  }
}

TEST_F(RecorderTest, CallsNothingSwingInWhichTheLegMayHaveLanded) {
  robot_.plan.gait.touchdown_jitter_s = 0.005;
  robot_.safety.stance_lead_s = 0.002;  // gains change 2 ms before the plan, the leg lands up to 5 ms before it
  JointRecording recording = recording_of("lf_kfe", "landing.csv");
  for (Tick tick = 0; tick < 10; ++tick) {
    recording.take(sensors(tick));
    recording.take(valve(tick, tick == 8 ? signals::Phase::kStance : signals::Phase::kSwing));
  }
  ASSERT_TRUE(recording.finish(10).ok());
  std::istringstream lines(bytes(path("landing.csv")));
  std::string line, swing;
  for (std::getline(lines, line); std::getline(lines, line);) {
    swing += line.back();
  }
  EXPECT_EQ(swing, "1111100001");
}

TEST_F(RecorderTest, SaysWhichTickIsMissingAndEndsTheFileBeforeIt) {
  JointRecording recording = recording_of("lf_kfe", "gap.csv");
  for (const Tick tick : {0, 1, 3, 2}) {
    recording.take(sensors(tick));
    recording.take(valve(tick));
  }
  EXPECT_EQ(recording.ticks(), 2);
  const auto finished = recording.finish(4);
  ASSERT_FALSE(finished.ok());
  EXPECT_EQ(finished.error().message, "the recording of lf_kfe lacks joint/sensors of tick 2: that of tick 3 came; the "
                                      "file ends before it");
  const std::string text = bytes(path("gap.csv"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST_F(RecorderTest, SaysWhatDidNotComeAtTheEnd) {
  JointRecording recording = recording_of("lf_kfe", "short.csv");
  recording.take(sensors(0));
  recording.take(sensors(1));
  recording.take(valve(0));
  const auto finished = recording.finish(2);
  ASSERT_FALSE(finished.ok());
  EXPECT_NE(finished.error().message.find("lacks joint/valve_command of tick 1"), std::string::npos);
}

TEST_F(RecorderTest, RefusesADirectoryThatCannotBe) {
  std::ofstream(path("file")) << "no directory";
  const participant::testing::TestRun run(1);
  const auto member = run.join(0, "gait_source");
  const auto recorder = Recorder::create(robot_, *member.participant, path("file") + "/below");
  ASSERT_FALSE(recorder.ok());
  EXPECT_NE(recorder.error().message.find(path("file")), std::string::npos);
}

TEST_F(RecorderTest, TakesEveryJointOffTheBus) {
  constexpr Tick kTicks = 3;
  participant::testing::TestRun run(1);
  const auto member = run.join(0, "gait_source");
  const auto sensors_out = member->publish<signals::JointSensors>(robot::joint_numbers(robot_), robot::legs_of_joints(robot_));
  const auto valves_out = member->publish<signals::JointValveCommand>(robot::joint_numbers(robot_));
  auto recorder = Recorder::create(robot_, *member.participant, path("all"));
  ASSERT_TRUE(recorder.ok()) << recorder.error().message;
  for (Tick tick = 0; tick < kTicks; ++tick) {
    for (const robot::Joint& joint : robot_.joints) {
      sensors_out.value()->publish(sensors(tick, joint.number));
      valves_out.value()->publish(valve(tick, signals::Phase::kStance, joint.number));
    }
    EXPECT_FALSE(recorder.value().has(tick + 1));
    recorder.value().poll();
    EXPECT_TRUE(recorder.value().has(tick + 1));
  }
  ASSERT_TRUE(recorder.value().finish(kTicks).ok());
  for (const robot::Joint& joint : robot_.joints) {
    const std::string text = bytes(Recorder::path_of(path("all"), joint.name));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), kTicks + 1) << joint.name;
  }
}

}  // namespace
}  // namespace farrier::lab
