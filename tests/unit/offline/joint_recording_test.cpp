// One joint of a recorded run, as diagnosis reads it.

#include "tools/offline/joint_recording.hpp"

#include <gtest/gtest.h>

#include "robot/robot.hpp"

namespace farrier::offline {
namespace joint_recording_test {

using signals::JointMeasurement;
using signals::Phase;

class JointRecordingTest : public testing::Test {
 protected:
  JointRecordingTest() { measured_.joints.resize(robot_.joints.size()); }

  void measure(Tick tick, Phase phase = Phase::kSwing) {
    measured_.joints[knee_.number].push_back({.joint = knee_.number,
                                              .tick = tick,
                                              .position_m_or_rad = 0.01 * static_cast<double>(tick),
                                              .force_N_or_Nm = 100.0 + static_cast<double>(tick),
                                              .valve_current_A = 1e-3 * static_cast<double>(tick + 1),
                                              .phase = phase});
  }
  diagnosis::Recording recording() const { return joint_recording(measured_, robot_, knee_); }

  robot::Robot robot_ = robot::load_robot(std::string(FARRIER_ROBOTS) + "/hyq.yaml").value();
  const robot::Joint& knee_ = *robot_.find("lf_kfe");
  playback::Measurements measured_{.lockstep = true, .joints = {}, .ending = {}};
};

TEST_F(JointRecordingTest, HasWhatWasMeasuredTickByTick) {
  for (const Tick tick : {0, 1, 2}) {
    measure(tick);
  }
  const diagnosis::Recording r = recording();
  EXPECT_EQ(r.coordinates, diagnosis::Coordinates::kLinear);
  EXPECT_DOUBLE_EQ(r.period_s, robot_.period_s);
  EXPECT_EQ(r.time_s, (std::vector<double>{0.0, robot_.period_s, 2.0 * robot_.period_s}));
  EXPECT_EQ(r.position, (std::vector<double>{0.0, 0.01, 0.02}));
  EXPECT_EQ(r.force, (std::vector<double>{100.0, 101.0, 102.0}));
  EXPECT_EQ(r.valve_current_A, (std::vector<double>{1e-3, 2e-3, 3e-3})) << "acts at once in this robot's lock-step";
  EXPECT_EQ(r.velocity.size(), 3u);
  EXPECT_TRUE(r.remarks.empty());
}

TEST_F(JointRecordingTest, GivesARowTheCurrentThatActsFromItOn) {
  robot_.loop_delay_lockstep = 2;
  for (const Tick tick : {0, 1, 2, 3}) {
    measure(tick);
  }
  EXPECT_EQ(recording().valve_current_A, (std::vector<double>{0.0, 0.0, 1e-3, 2e-3}));
}

TEST_F(JointRecordingTest, LeavesOutWhatActedBeforeItBegan) {
  robot_.loop_delay_realtime = 1;
  measured_.lockstep = false;
  for (const Tick tick : {700, 701, 702}) {
    measure(tick);
  }
  const diagnosis::Recording r = recording();
  EXPECT_EQ(r.force, (std::vector<double>{801.0, 802.0}));
  EXPECT_EQ(r.valve_current_A, (std::vector<double>{1e-3 * 701.0, 1e-3 * 702.0}));
}

TEST_F(JointRecordingTest, CallsNothingSwingInWhichTheLegMayHaveLanded) {
  robot_.plan.gait.touchdown_jitter_s = 0.005;
  robot_.safety.stance_lead_s = 0.002;  // gains change 2 ms before the plan, the leg lands up to 5 ms before it
  for (Tick tick = 0; tick < 10; ++tick) {
    measure(tick, tick == 8 ? Phase::kStance : Phase::kSwing);
  }
  EXPECT_EQ(recording().swing, (std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0, 0, 0, 0, 1}));
}

TEST_F(JointRecordingTest, TakesTheLongestStretchWithoutAHoleAndSaysSo) {
  for (const Tick tick : {0, 1, 3, 4, 5, 9}) {
    measure(tick);
  }
  const diagnosis::Recording r = recording();
  EXPECT_EQ(r.force, (std::vector<double>{103.0, 104.0, 105.0}));
  ASSERT_EQ(r.remarks.size(), 1u);
  EXPECT_EQ(r.remarks.front(),
            "The recording of lf_kfe has holes: of 6 samples the 3 from tick 3 on, which are in a "
            "row, are taken.");
}

TEST_F(JointRecordingTest, IsEmptyWithoutMeasurements) { EXPECT_TRUE(recording().time_s.empty()); }

TEST_F(JointRecordingTest, RefusesWhatIsNoRecording) {
  const auto read = read_joint_recording("/nowhere/run.mcap", "lf_kfe");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.error().findings.front().what, "unreadable");
}

}  // namespace joint_recording_test
}  // namespace farrier::offline
