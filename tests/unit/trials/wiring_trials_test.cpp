// Faults of wiring, put into recordings of a generator that shares no code with what looks for them.

#include <gtest/gtest.h>

#include "tests/unit/robot/test_files.hpp"
#include "trials/wiring/wiring_faults.hpp"
#include "trials/wiring/wiring_trials.hpp"

namespace farrier::wiring {
namespace wiring_trials_test {

const robot::Joint& rig() {
  static const robot::Robot robot = robot::load_shipped("fc1d");
  return robot.joints.front();
}
const robot::Joint& leg() {
  static const robot::Robot robot = robot::load_shipped("hyq");
  return *robot.find("lf_haa");
}

const robot::Joint& electric() {
  static const robot::Robot robot = robot::load_shipped("electric_leg");
  return robot.joints.front();
}
const robot::Joint& electric_leg() {
  static const robot::Robot robot = robot::load_shipped("go1");
  return *robot.find("lf_haa");
}

diagnosis::Recording good(const robot::Joint& joint, const std::vector<truth::Hidden>& hidden = {}) {
  const auto trial = truth::generate(
      joint, 1e-3, {.seed = 7, .excitation = truth::Excitation::kRandomSteps, .hidden = hidden, .duration_s = 3.0});
  EXPECT_TRUE(trial.ok());
  return recording_of(trial.value().samples, joint);
}

TEST(Wiring, EveryKindOfFaultIsNamedWithItsChannel) {
  const diagnosis::Recording recording = good(rig());
  const diagnosis::OtherJoint other{"lf_haa", good(leg())};
  for (const FaultKind& kind : fault_kinds()) {
    diagnosis::Recording faulty = recording;
    const diagnosis::WiringFault fault = kind.put(faulty, rig(), other, 3);
    const auto answers = diagnosis::find_wiring(faulty, rig(), {&other, 1});
    ASSERT_FALSE(answers.empty()) << kind.name;
    EXPECT_TRUE(is_fault(answers.front().fault, fault)) << kind.name;
    EXPECT_GT(answers.front().confidence, 0.5) << kind.name;
    EXPECT_LE(answers.front().confidence, 1.0) << kind.name;
  }
}

TEST(Wiring, EveryKindOfFaultOfAnElectricJointIsNamedWithItsChannel) {
  const diagnosis::OtherJoint other{"lf_haa", good(electric_leg())};
  const diagnosis::Recording recording = good(electric());
  EXPECT_TRUE(diagnosis::find_wiring(recording, electric()).empty());
  for (const FaultKind& kind : fault_kinds(true)) {
    diagnosis::Recording faulty = recording;
    const diagnosis::WiringFault fault = kind.put(faulty, electric(), other, 3);
    const auto answers = diagnosis::find_wiring(faulty, electric(), {&other, 1});
    ASSERT_FALSE(answers.empty()) << kind.name;
    EXPECT_TRUE(is_fault(answers.front().fault, fault)) << kind.name;
  }
}

TEST(Wiring, ALagOfTwoSamplesIsNamed) {
  const diagnosis::Recording recording = good(rig());
  const diagnosis::OtherJoint other{"lf_haa", good(leg())};
  for (const FaultKind& kind : fault_kinds()) {
    if (kind.name.ends_with(" late") || kind.name.ends_with(" early")) {
      diagnosis::Recording faulty = recording;
      const diagnosis::WiringFault fault = kind.put(faulty, rig(), other, 0);
      const auto answers = diagnosis::find_wiring(faulty, rig());
      ASSERT_FALSE(answers.empty()) << kind.name;
      EXPECT_TRUE(is_fault(answers.front().fault, fault)) << kind.name;
    }
  }
}

TEST(Wiring, NoFaultIsNamedInGoodRecordings) {
  EXPECT_TRUE(diagnosis::find_wiring(good(rig()), rig()).empty());
  EXPECT_TRUE(diagnosis::find_wiring(good(leg()), leg()).empty());
}

TEST(Wiring, DelaysFiltersAndGainsOfAJointAreNoFaults) {
  for (const char* effect : {"input_delay", "force_sensor_lag", "velocity_filter_lag", "force_sensor_gain"}) {
    EXPECT_TRUE(diagnosis::find_wiring(good(rig(), {{effect, 2}}), rig()).empty()) << effect;
  }
}

TEST(Wiring, AForceOfAnotherJointUnderTwoNamesIsNamedWithBoth) {
  diagnosis::Recording recording = good(rig());
  const diagnosis::OtherJoint other{"lf_haa", good(leg())};
  recording.force = other.recording.force;
  const auto answers = diagnosis::find_wiring(recording, rig(), {&other, 1});
  ASSERT_FALSE(answers.empty());
  const auto findings = diagnosis::wiring_findings(answers, recording, rig());
  EXPECT_NE(findings.front().text.find("force_N of fc1d is that of joint lf_haa"), std::string::npos)
      << findings.front().text;
}

TEST(Wiring, AShortRecordingHasNoAnswer) {
  diagnosis::Recording recording = good(rig());
  for (auto* const values :
       {&recording.time_s, &recording.position, &recording.velocity, &recording.force, &recording.valve_current_A,
        &recording.pressure_a_Pa, &recording.pressure_b_Pa, &recording.supply_pressure_Pa}) {
    values->resize(100);
  }
  EXPECT_TRUE(diagnosis::find_wiring(recording, rig()).empty());
}

}  // namespace wiring_trials_test
}  // namespace farrier::wiring
