#include "diagnosis/data/trace_recording.hpp"

#include "diagnosis/data/recording_check.hpp"
#include "recording.hpp"
#include "trace/trace.hpp"
#include "robot/keys.hpp"

namespace farrier::diagnosis {
namespace trace_recording_test {

class TraceRecording : public RecordingFile {
 protected:
  /// A trace of three joints, of which the second does what the bench does; swing from 500 to 999.
  void write(const std::function<bool(Tick)>& kept = [](Tick) { return true; }) const {
    auto writer = trace::TraceWriter::create(path_, robot::joint_names(robot_));
    ASSERT_TRUE(writer);
    for (Tick tick = 0; tick < 2000; ++tick) {
      for (std::uint16_t joint = 0; joint < 3 && kept(tick); ++joint) {
        const auto i = static_cast<std::size_t>(tick);
        const double share = joint == 1 ? 1.0 : 0.5;
        writer.value().write({.tick = tick,
                              .joint = joint,
                              .position_m_or_rad = share * made_.position[i],
                              .velocity_m_s_or_rad_s = share * made_.velocity[i],
                              .force_N_or_Nm = share * made_.force[i],
                              .pressure_a_Pa = made_.pressure_a_Pa[i],
                              .pressure_b_Pa = made_.pressure_b_Pa[i],
                              .valve_current_A = made_.valve_current_A[i],
                              .phase = Phase::kStance,
                              .actual_phase = tick >= 500 && tick < 1000 ? Phase::kSwing : Phase::kStance});
      }
    }
    ASSERT_TRUE(writer.value().finish());
  }
  auto read_joint(const std::string& name) const { return recording_of_trace(path_, robot_, *robot_.find(name)); }
  std::string refusal(const std::string& name) const {
    const auto recording = read_joint(name);
    return recording ? "accepted" : to_string(recording.error().findings, "");
  }

  const robot::Robot robot_ = robot::load_shipped("hyq");
  const Recording made_ = TestBench{}.recording();
};

TEST_F(TraceRecording, HoldsTheRowsOfItsJoint) {
  write();
  const auto recording = read_joint("lf_hfe");
  ASSERT_TRUE(recording) << refusal("lf_hfe");
  const Recording& r = recording.value();
  EXPECT_EQ(r.coordinates, Coordinates::kLinear);
  EXPECT_EQ(r.period_s, robot_.period_s);
  EXPECT_EQ(r.position, made_.position);
  EXPECT_EQ(r.velocity, made_.velocity);
  EXPECT_EQ(r.force, made_.force);
  EXPECT_EQ(r.valve_current_A, made_.valve_current_A);
  EXPECT_EQ(r.pressure_a_Pa, made_.pressure_a_Pa);
  EXPECT_EQ(r.pressure_b_Pa, made_.pressure_b_Pa);
  EXPECT_EQ(r.time_s[1500], 1500 * robot_.period_s);
  EXPECT_EQ(r.line[10], 2u + 3 * 10 + 1);
  ASSERT_EQ(r.swing.size(), 2000u);
  for (std::size_t i = 0; i < r.swing.size(); ++i) {
    EXPECT_EQ(r.swing[i], i >= 500 && i < 1000 ? 1 : 0);
  }
  EXPECT_FALSE(r.velocity_derived);
  EXPECT_EQ(r.remarks.size(), 1u);
  EXPECT_EQ(summary(check_recording(r, *robot_.find("lf_hfe"))), "");
}

TEST_F(TraceRecording, KnowsWhatMovesEveryJoint) {
  for (const robot::Joint& joint : robot_.joints) {
    EXPECT_EQ(coordinates_of(joint) == Coordinates::kRotary, joint.name.ends_with("_haa")) << joint.name;
  }
  const robot::Robot rig = robot::load_shipped("fc1d");
  EXPECT_EQ(coordinates_of(rig.joints[0]), Coordinates::kLinear);
  write();
  EXPECT_EQ(read_joint("lf_haa").value().coordinates, Coordinates::kRotary);
}

TEST_F(TraceRecording, IsToldFromARecordingByItsHeader) {
  write();
  EXPECT_TRUE(is_trace(path_));
  std::ofstream(path_) << "time_s,position_m,force_N\n";
  EXPECT_FALSE(is_trace(path_));
  std::ofstream(path_) << "";
  EXPECT_FALSE(is_trace(path_));
  EXPECT_FALSE(is_trace("/nowhere/trace.csv"));
  EXPECT_FALSE(is_trace("/"));
}

TEST_F(TraceRecording, NamesMissingTicks) {
  write([](Tick tick) { return tick != 700 && (tick < 900 || tick > 909); });
  EXPECT_EQ(refusal("lf_hfe"),
            ":2103: lines 2103 and 2700, time: 2 gaps before, up to 0.011 s where samples are "
            "0.001 s apart; keep the longest part without one, or record without loss\n");
}

TEST_F(TraceRecording, NamesTheJointsItHasWhenOneIsMissing) {
  write();
  EXPECT_EQ(refusal("rh_kfe"),
            ": the file has no rows of joint rh_kfe; it has 'lf_haa', 'lf_hfe', 'lf_kfe'; give the "
            "robot file of the run, and one of its joints\n");
}

TEST_F(TraceRecording, RefusesWhatIsNoTrace) {
  std::ofstream(path_) << "tick,joint,position_m_or_rad\n1,lf_hfe,2\n";
  EXPECT_TRUE(mentions(refusal("lf_hfe"), "line 1, column actual_phase is missing; give a trace of this version"));
  std::ofstream(path_) << "time_s,position_m,force_N\n1,2,3\n";
  EXPECT_TRUE(mentions(refusal("lf_hfe"), "names no column of a recording"));
  write([](Tick tick) { return tick < 100; });
  EXPECT_TRUE(mentions(refusal("lf_hfe"), "the file holds 100 samples over 0.1 s"));
}

}  // namespace trace_recording_test
}  // namespace farrier::diagnosis
