#include <cmath>
#include <random>

#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace reference_test {

using namespace testing;
using signals::JointState;

// A dozen roundings, of terms that may cancel down to a thousandth.
constexpr double kRounding = 1e-11;

TEST(JointNode, AsksForTheCommandedTorqueOverTheLeverArm) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  int within_limits = 0;
  for (const robot::Joint& joint : hyq().joints) {
    Bench bench = Bench::tracking(joint.name);
    for (int i = 0; i < 50; ++i) {
      auto& sensors = bench.inputs.sensors;
      auto& command = bench.inputs.command;
      sensors.position_m_or_rad = joint.actuator.stroke * (0.1 + 0.8 * share(random));
      sensors.velocity_m_s_or_rad_s = 0.2 * share(random) - 0.1;
      const double q = bench.angle();
      const double q_dot = joint.linkage.angular_velocity(q, sensors.velocity_m_s_or_rad_s);
      command.position_rad = joint.angle_min_rad + share(random) * (joint.angle_max_rad - joint.angle_min_rad);
      command.velocity_rad_s = 4.0 * share(random) - 2.0;
      command.torque_ff_Nm = 40.0 * share(random) - 20.0;
      command.stiffness_Nm_rad = 100.0 * share(random);
      command.damping_Nms_rad = 5.0 * share(random);
      const double tau = command.torque_ff_Nm + command.stiffness_Nm_rad * (command.position_rad - q) +
                         command.damping_Nms_rad * (command.velocity_rad_s - q_dot);
      const double expected = tau / joint.linkage.lever(q);
      bench.next_tick += 20;  // long enough to get anywhere
      const auto outputs = bench.step();
      if (expected < joint.push_limit && expected > -joint.pull_limit) {
        ++within_limits;
        EXPECT_NEAR(outputs.valve.force_reference_N_or_Nm, expected, kRounding * joint.push_limit) << joint.name;
        EXPECT_FALSE(has(outputs, Fault::kReferenceClamped));
      } else {
        EXPECT_TRUE(has(outputs, Fault::kReferenceClamped));
      }
    }
  }
  EXPECT_GT(within_limits, 300) << "of 600: the test must look where nothing is clamped";
}

TEST(JointNode, ClampsTheForceToWhatTheActuatorCanPushAndPull) {
  Bench bench = Bench::tracking();
  const double lever = bench.joint.linkage.lever(bench.angle());
  bench.inputs.command.torque_ff_Nm = std::copysign(1e5, lever);
  auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.force_reference_N_or_Nm, bench.joint.push_limit);
  EXPECT_TRUE(has(outputs, Fault::kReferenceClamped));
  bench.inputs.command.torque_ff_Nm = -bench.inputs.command.torque_ff_Nm;
  outputs = bench.step();
  EXPECT_EQ(outputs.valve.force_reference_N_or_Nm, -bench.joint.pull_limit);
  EXPECT_EQ(outputs.valve.state, JointState::kTracking) << "a clamped reference is tracked";
  bench.inputs.command.torque_ff_Nm = 0;
  EXPECT_FALSE(has(bench.step(), Fault::kReferenceClamped)) << "clears by itself";
}

TEST(JointNode, ClampsTheReferencePositionToTheJointsLimits) {
  for (const bool above : {true, false}) {
    Bench bench = Bench::tracking();
    Bench at_limit = Bench::tracking();
    const double limit = above ? bench.joint.angle_max_rad : bench.joint.angle_min_rad;
    bench.inputs.command.stiffness_Nm_rad = at_limit.inputs.command.stiffness_Nm_rad = 30;
    bench.inputs.command.position_rad = limit + (above ? 0.5 : -0.5);
    at_limit.inputs.command.position_rad = limit;
    const auto outputs = bench.step();
    EXPECT_TRUE(has(outputs, Fault::kReferenceClamped));
    const auto expected = at_limit.step();
    EXPECT_FALSE(has(expected, Fault::kReferenceClamped));
    EXPECT_EQ(outputs.valve.force_reference_N_or_Nm, expected.valve.force_reference_N_or_Nm);
  }
}

TEST(JointNode, SaysWhenTheValveSaturates) {
  Bench bench = Bench::tracking();
  bench.inputs.command.torque_ff_Nm = 150;
  EXPECT_FALSE(has(bench.step(), Fault::kValveSaturated));
  const auto outputs = bench.step_to(50);  // the force stays away and the integrator works on
  EXPECT_TRUE(has(outputs, Fault::kValveSaturated));
  EXPECT_EQ(std::abs(outputs.valve.valve_current_A), bench.joint.actuator.valve_current_max_A);
}

TEST(JointNode, StaysWithinTheValvesCurrentWhateverScaleTheGainsCameWith) {
  Bench bench;
  bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  auto signal = gains_of(bench.joint, signals::Phase::kStance, 1);
  signal.current_scale_A *= 100;
  for (double& row : signal.model_b) {
    row /= 100;  // keeps the loop it came with as stable as it was
  }
  ASSERT_TRUE(check_gains(signal, control::Kind::kLqr)) << check_gains(signal, control::Kind::kLqr).error().message;
  bench.offer(signal);
  bench.inputs.command.torque_ff_Nm = 150;
  const auto outputs = bench.step();
  EXPECT_EQ(std::abs(outputs.valve.valve_current_A), bench.joint.actuator.valve_current_max_A);
  EXPECT_TRUE(has(outputs, Fault::kValveSaturated));
}

TEST(JointNode, OpensTheValveTowardsTheMissingForce) {
  for (const robot::Joint& joint : hyq().joints) {
    Bench bench = Bench::tracking(joint.name);
    const double lever = joint.linkage.lever(bench.angle());
    bench.inputs.command.torque_ff_Nm = std::copysign(10, lever);
    EXPECT_GT(bench.step().valve.valve_current_A, 0.0) << joint.name;
  }
}

TEST(JointNode, AnswersTheSampleItWasGiven) {
  Bench bench = Bench::tracking();
  bench.step_to(41);
  bench.inputs.sensors.sample_time_ns = 123'456;
  bench.inputs.sensors.force_N_or_Nm = 11;
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0.01;
  const auto [valve, measurement] = bench.step();
  EXPECT_EQ(valve.joint, bench.joint.number);
  EXPECT_EQ(valve.tick, 42);
  EXPECT_EQ(valve.sample_time_ns, 123'456) << "carried through, so latency is measurable";
  EXPECT_EQ(measurement.joint, bench.joint.number);
  EXPECT_EQ(measurement.tick, 42);
  EXPECT_EQ(measurement.sample_time_ns, 123'456);
  EXPECT_EQ(measurement.position_m_or_rad, bench.inputs.sensors.position_m_or_rad);
  EXPECT_EQ(measurement.velocity_m_s_or_rad_s, 0.01);
  EXPECT_EQ(measurement.force_N_or_Nm, 11);
  EXPECT_EQ(measurement.valve_current_A, valve.valve_current_A);
  EXPECT_EQ(measurement.force_reference_N_or_Nm, valve.force_reference_N_or_Nm);
  EXPECT_EQ(measurement.faults, valve.faults);
  EXPECT_EQ(measurement.state, valve.state);
  EXPECT_EQ(measurement.phase, valve.phase);
}

}  // namespace reference_test
}  // namespace farrier::joint_node
