// A joint whose robot file says feedback_linearisation or pid: no gains needed, everything else as ever.

#include <cmath>
#include <limits>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace flow_law_test {

using namespace testing;
using signals::JointState;

const robot::Joint& flow_law_joint() {
  static const robot::Joint joint = [] {
    robot::Joint changed = joint_named("lf_kfe");
    changed.kind = control::Kind::kFeedbackLinearisation;
    return changed;
  }();
  return joint;
}

Bench armed() {
  Bench bench(flow_law_joint());
  bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  return bench;
}

TEST(JointNode, TracksByTheFlowLawWithoutGains) {
  Bench bench = armed();
  const auto first = bench.step();
  EXPECT_EQ(first.valve.state, JointState::kTracking);
  EXPECT_EQ(first.valve.faults, 0u);
  bench.inputs.command.torque_ff_Nm = 20.0;
  const auto second = bench.step();
  EXPECT_GT(second.valve.valve_current_A * second.valve.force_reference_N_or_Nm, 0.0);
}

TEST(JointNode, IgnoresGainsThatComeWhileTheFlowLawActs) {
  Bench bench = armed();
  Bench offered = armed();
  for (int i = 0; i < 20; ++i) {
    bench.inputs.command.torque_ff_Nm = offered.inputs.command.torque_ff_Nm = i;
    if (i == 5) {
      offered.offer(gains_of(offered.joint, signals::Phase::kStance, 1));
    }
    EXPECT_EQ(bench.step().valve.valve_current_A, offered.step().valve.valve_current_A) << i;
  }
}

TEST(JointNode, NullsTheFlowLawsValveAndStartsItAfreshWhenSensorsReturn) {
  Bench bench = armed();
  bench.inputs.command.torque_ff_Nm = 20.0;
  bench.step();
  EXPECT_NE(bench.step().valve.valve_current_A, 0.0);
  bench.inputs.sensors.velocity_m_s_or_rad_s = std::numeric_limits<double>::quiet_NaN();
  expect_null(bench.step(), Fault::kSensorsStale);
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0.0;
  const auto back = bench.step_to(bench.next_tick + hyq().safety.recovery_samples - 1);
  EXPECT_EQ(back.valve.state, JointState::kTracking);
  EXPECT_EQ(back.valve.valve_current_A, 0.0);
  EXPECT_NE(bench.step().valve.valve_current_A, 0.0);
}

TEST(JointNode, RunsThePidOfItsFileWithoutGainsAndStartsItAfreshAfterNull) {
  robot::Joint joint = joint_named("lf_kfe");
  joint.kind = control::Kind::kPid;
  joint.pid = {.proportional = 1.0, .integral_1_s = 100.0, .derivative_s = 0.0, .derivative_filter_Hz = 200.0};
  Bench bench(joint);
  bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  bench.inputs.command.torque_ff_Nm = 20.0;
  const auto first = bench.step();
  EXPECT_EQ(first.valve.state, JointState::kTracking);
  EXPECT_EQ(first.valve.faults, 0u);
  const double error =
      (first.valve.force_reference_N_or_Nm - bench.inputs.sensors.force_N_or_Nm) / joint.normalisation.force;
  EXPECT_NEAR(first.valve.valve_current_A, joint.normalisation.current_A * error, 1e-15);
  EXPECT_NE(bench.step().valve.valve_current_A, first.valve.valve_current_A) << "integrates";
  bench.inputs.sensors.velocity_m_s_or_rad_s = std::numeric_limits<double>::quiet_NaN();
  expect_null(bench.step(), Fault::kSensorsStale);
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0.0;
  const auto back = bench.step_to(bench.next_tick + hyq().safety.recovery_samples - 1);
  EXPECT_EQ(back.valve.valve_current_A, first.valve.valve_current_A);
}

TEST(JointNode, SaysWhenTheFlowLawOpensTheValveFully) {
  Bench bench = armed();
  bench.step();
  bench.inputs.command.torque_ff_Nm = 1e3;
  bench.inputs.sensors.force_N_or_Nm = -4.0 * bench.joint.push_limit;
  bench.inputs.sensors.velocity_m_s_or_rad_s = 10.0;
  const auto outputs = bench.step();
  EXPECT_EQ(std::abs(outputs.valve.valve_current_A), bench.joint.actuator.valve_current_max_A);
  EXPECT_TRUE(has(outputs, Fault::kValveSaturated));
}

}  // namespace flow_law_test
}  // namespace farrier::joint_node
