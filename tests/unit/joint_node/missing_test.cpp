// The rows of "what a joint does when something is missing" for sensors and commands.

#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace missing_test {

using namespace testing;
using signals::JointState;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNotFinite[] = {kNan, kInfinity, -kInfinity};

TEST(JointNode, TracksWhileNothingIsMissing) {
  Bench bench = Bench::tracking();
  const auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.state, JointState::kTracking);
  EXPECT_EQ(FaultSet(outputs.valve.faults), FaultSet{});
}

TEST(JointNode, PublishesWhichSamplesItUsed) {
  Bench bench = Bench::tracking();
  EXPECT_EQ(bench.step().measurement.phase_count, 0u);
  bench.announce(signals::Phase::kSwing, 7, 0);
  const signals::JointMeasurement measurement = bench.step().measurement;
  EXPECT_EQ(measurement.command_tick, bench.inputs.command.tick);
  EXPECT_EQ(measurement.mode_epoch, 1u);
  EXPECT_EQ(measurement.phase_count, 7u);
}

TEST(JointNode, NullsValveWhenSensorsAreOlderThanThreeMilliseconds) {
  Bench bench = Bench::tracking();
  bench.inputs.sensors_age_s = 0.003;
  EXPECT_EQ(bench.state(), JointState::kTracking);
  bench.inputs.sensors_age_s = 0.0031;
  expect_null(bench.step(), Fault::kSensorsStale);
}

TEST(JointNode, NullsValveWhenThereWereNoSensorsYet) {
  Bench bench = Bench::tracking();
  bench.inputs.sensors_age_s = kInfinity;
  expect_null(bench.step(), Fault::kSensorsStale);
}

TEST(JointNode, NullsValveWhenPositionOrVelocityIsNotFinite) {
  for (const double bad : kNotFinite) {
    for (double signals::JointSensors::*field :
         {&signals::JointSensors::position_m_or_rad, &signals::JointSensors::velocity_m_s_or_rad_s}) {
      Bench bench = Bench::tracking();
      EXPECT_EQ(bench.state(), JointState::kTracking);
      bench.inputs.sensors.*field = bad;
      expect_null(bench.step(), Fault::kSensorsStale);
    }
  }
}

TEST(JointNode, IgnoresReadingsOutsideTheJointsRange) {
  const robot::Joint& joint = joint_named("lf_kfe");
  const double stroke = joint.actuator.stroke;
  const double home = joint.linkage.position(joint.home_angle_rad);
  const double force = std::max(joint.push_limit, joint.pull_limit);
  struct Reading {
    double position, force;
    JointState makes;
  };
  using enum JointState;
  for (const Reading& reading :
       {Reading{home, 4.9 * force, kTracking}, Reading{home, -4.9 * force, kTracking},
        Reading{home, 5.1 * force, kDamping}, Reading{home, -5.1 * force, kDamping},
        Reading{1.02 * stroke, -20.0 * force, kTracking}, Reading{-0.09 * stroke, 0, kTracking},
        Reading{1.09 * stroke, 0, kTracking}, Reading{-0.11 * stroke, 0, kNull}, Reading{1.11 * stroke, 0, kNull},
        Reading{1e308, 0, kNull}, Reading{home, -1e308, kDamping}}) {
    Bench bench = Bench::tracking();
    bench.step();
    bench.next_tick += 20;  // long enough to get there
    bench.inputs.sensors.position_m_or_rad = reading.position;
    bench.inputs.sensors.force_N_or_Nm = reading.force;
    EXPECT_EQ(bench.state(), reading.makes) << reading.position << " m, " << reading.force << " N";
  }
}

TEST(JointNode, NullsValveWhenThePositionJumps) {
  Bench bench = Bench::tracking();
  const double stroke = bench.joint.actuator.stroke;
  bench.step();
  bench.inputs.sensors.position_m_or_rad += 0.09 * stroke;
  EXPECT_EQ(bench.state(), JointState::kTracking);
  bench.inputs.sensors.position_m_or_rad -= 0.11 * stroke;
  expect_null(bench.step(), Fault::kSensorsStale);
}

TEST(JointNode, ForgetsTheLastPositionOnceTheJointCanHaveGoneAnywhere) {
  Bench bench = Bench::tracking();
  bench.inputs.sensors.position_m_or_rad = 0.0;
  bench.step();
  bench.next_tick += 12;
  bench.inputs.sensors.position_m_or_rad = bench.joint.actuator.stroke;
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, NullsValveWhenSensorsAreFrozen) {
  robot::Safety safety = hyq().safety;
  safety.frozen_samples = 5;
  Bench bench = Bench::tracking(joint_named("lf_kfe"), safety);
  for (int alike = 0; alike < 5; ++alike) {
    EXPECT_EQ(bench.state(), JointState::kTracking) << alike;
  }
  expect_null(bench.step(), Fault::kSensorsStale);
  for (int good = 1; good < safety.recovery_samples; ++good) {
    bench.inputs.sensors.force_N_or_Nm += 0.5;
    expect_null(bench.step(), Fault::kSensorsStale);
  }
  bench.inputs.sensors.force_N_or_Nm += 0.5;
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, SaysNothingOfFrozenSensorsWhileNoneCome) {
  robot::Safety safety = hyq().safety;
  safety.frozen_samples = 3;
  Bench bench = Bench::tracking(joint_named("lf_kfe"), safety);
  bench.step();
  const Tick newest = bench.inputs.sensors.tick;
  for (int period = 0; period < 10; ++period) {
    ++bench.inputs.tick;
    bench.inputs.sensors.tick = newest;
    EXPECT_EQ(static_cast<JointState>(bench.node.step(bench.inputs).valve.state), JointState::kTracking);
  }
}

TEST(JointNode, RecoversAfterTenGoodSamples) {
  ASSERT_EQ(hyq().safety.recovery_samples, 10);
  Bench bench = Bench::tracking();
  bench.inputs.sensors_age_s = 0.010;
  bench.step();
  bench.inputs.sensors_age_s = 0;
  for (int good = 1; good < 10; ++good) {
    expect_null(bench.step(), Fault::kSensorsStale);
  }
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, StartsCountingAgainAfterAnotherBadSample) {
  Bench bench = Bench::tracking();
  bench.inputs.sensors_age_s = 0.010;
  bench.step();
  bench.inputs.sensors_age_s = 0;
  for (int good = 1; good < 10; ++good) {
    bench.step();
  }
  bench.inputs.sensors.velocity_m_s_or_rad_s = kNan;
  bench.step();
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0;
  for (int good = 1; good < 10; ++good) {
    expect_null(bench.step(), Fault::kSensorsStale);
  }
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, CountsASampleItSeesTwiceOnceTowardsRecovery) {
  Bench bench = Bench::tracking();
  bench.inputs.sensors_age_s = 0.010;
  bench.step();
  bench.inputs.sensors_age_s = 0.002;
  for (int sample = 1; sample < 10; ++sample) {
    expect_null(bench.step(), Fault::kSensorsStale);
    expect_null(bench.node.step(bench.inputs), Fault::kSensorsStale);
  }
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, StartsAfreshAfterAStaleSpell) {
  Bench fresh = Bench::tracking();
  fresh.inputs.command.torque_ff_Nm = 5;
  const double first_current_A = fresh.step().valve.valve_current_A;
  Bench bench = Bench::tracking();
  bench.inputs.command.torque_ff_Nm = 5;
  for (int i = 0; i < 50; ++i) {
    bench.step();  // fills the integrator
  }
  EXPECT_NE(bench.step().valve.valve_current_A, first_current_A);
  bench.inputs.sensors_age_s = 0.010;
  bench.step();
  bench.inputs.sensors_age_s = 0;
  for (int good = 1; good < 10; ++good) {
    bench.step();
  }
  EXPECT_EQ(bench.step().valve.valve_current_A, first_current_A);
}

TEST(JointNode, DampsWhenTheCommandIsOlderThanFiveMilliseconds) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.005;
  EXPECT_EQ(bench.state(), JointState::kTracking);
  bench.inputs.command_age_s = 0.0051;
  const auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.state, JointState::kDamping);
  EXPECT_TRUE(has(outputs, Fault::kCommandStale));
  bench.inputs.command_age_s = 0;
  EXPECT_EQ(bench.state(), JointState::kTracking) << "clears by itself";
}

TEST(JointNode, DampsWithVelocityFeedbackOnly) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.006;
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0.1;
  const double q = bench.angle();
  const double q_dot = bench.joint.linkage.angular_velocity(q, 0.1);
  const double expected = bench.joint.linkage.force(q, -hyq().safety.damping_gain_Nms_rad * q_dot);
  EXPECT_DOUBLE_EQ(bench.step().valve.force_reference_N_or_Nm, expected);

  bench.inputs.command.position_rad += 0.5;
  bench.inputs.command.velocity_rad_s = 3;
  bench.inputs.command.torque_ff_Nm = 80;
  bench.inputs.command.stiffness_Nm_rad = 900;
  EXPECT_DOUBLE_EQ(bench.step().valve.force_reference_N_or_Nm, expected) << "an old command has no say";
}

TEST(JointNode, AsksForNoForceWhenItDampsAtRest) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.006;
  EXPECT_EQ(bench.step().valve.force_reference_N_or_Nm, 0.0);
}

TEST(JointNode, DampingAlwaysDissipates) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const robot::Joint& joint : hyq().joints) {
    Bench bench = Bench::tracking(joint.name);
    bench.inputs.command_age_s = 0.006;
    for (int i = 0; i < 200; ++i) {
      const double velocity = 4.0 * share(random) - 2.0;
      bench.next_tick += 20;  // long enough to get anywhere
      bench.inputs.sensors.position_m_or_rad = share(random) * joint.actuator.stroke;
      bench.inputs.sensors.velocity_m_s_or_rad_s = velocity;
      EXPECT_LE(bench.step().valve.force_reference_N_or_Nm * velocity, 0.0) << joint.name << " at " << velocity;
    }
  }
}

TEST(JointNode, DampsWhenTheCommandIsNotFinite) {
  for (const double bad : kNotFinite) {
    for (double signals::JointCommand::*field :
         {&signals::JointCommand::position_rad, &signals::JointCommand::velocity_rad_s,
          &signals::JointCommand::torque_ff_Nm, &signals::JointCommand::stiffness_Nm_rad,
          &signals::JointCommand::damping_Nms_rad}) {
      Bench bench = Bench::tracking();
      const double good = bench.inputs.command.*field;
      bench.inputs.command.*field = bad;
      EXPECT_EQ(bench.state(), JointState::kDamping);
      bench.inputs.command.*field = good;
      EXPECT_EQ(bench.state(), JointState::kTracking) << "clears by itself";
    }
  }
}

TEST(JointNode, DampsWhenTheCommandAsksForNegativeImpedance) {
  for (double signals::JointCommand::*impedance :
       {&signals::JointCommand::stiffness_Nm_rad, &signals::JointCommand::damping_Nms_rad}) {
    Bench bench = Bench::tracking();
    bench.inputs.command.*impedance = -1;
    EXPECT_EQ(bench.state(), JointState::kDamping);
  }
}

TEST(JointNode, PutsLostSensorsBeforeALostCommand) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.006;
  bench.inputs.sensors_age_s = 0.006;
  const auto outputs = bench.step();
  expect_null(outputs, Fault::kSensorsStale);
  EXPECT_TRUE(has(outputs, Fault::kCommandStale)) << "both are said";
}

}  // namespace missing_test
}  // namespace farrier::joint_node
