// The text that farrier echo prints for a sample.

#include "report/figures/sample_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace farrier::report {
namespace sample_text_test {

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_robot(FARRIER_ROBOTS "/hyq.yaml").value();
  return robot;
}

TEST(SampleText, NamesEveryFieldAndSaysWordsForWhatHasSome) {
  signals::JointValveCommand valve;
  valve.joint = hyq().joints[2].number;
  valve.tick = 155;
  valve.valve_current_A = -0.002;
  valve.state = signals::JointState::kTracking;
  valve.phase = signals::Phase::kStance;
  EXPECT_EQ(sample_text(valve, hyq()),
            "{joint: lf_kfe, tick: 155, sample_time_ns: 0, valve_current_A: -0.002, force_reference_N_or_Nm: 0, "
            "generation: 0, faults: 0, state: tracking, phase: stance}");
}

TEST(SampleText, LeavesNumbersWhatHasNoWord) {
  signals::JointValveCommand valve;
  valve.joint = 999;
  valve.state = static_cast<signals::JointState>(77);
  valve.phase = static_cast<signals::Phase>(9);
  const std::string text = sample_text(valve, hyq());
  EXPECT_TRUE(text.starts_with("{joint: 999, ")) << text;
  EXPECT_TRUE(text.ends_with("state: 77, phase: 9}")) << text;
}

TEST(SampleText, IsOneLineOfYamlWhateverASampleHolds) {
  signals::SystemEvent event;
  const std::string_view said = "a \"word\"\nand \\";
  std::copy(said.begin(), said.end(), event.text.begin());
  EXPECT_NE(sample_text(event, hyq()).find(R"(text: "a \"word\" and \\")"), std::string::npos)
      << sample_text(event, hyq());
  signals::JointSensors sensors;
  sensors.force_N_or_Nm = std::numeric_limits<double>::quiet_NaN();
  sensors.velocity_m_s_or_rad_s = -std::numeric_limits<double>::infinity();
  const std::string text = sample_text(sensors, hyq());
  EXPECT_NE(text.find("force_N_or_Nm: .nan"), std::string::npos) << text;
  EXPECT_NE(text.find("velocity_m_s_or_rad_s: -.inf"), std::string::npos) << text;
}

}  // namespace sample_text_test
}  // namespace farrier::report
