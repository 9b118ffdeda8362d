// A joint whose load cell says nothing holds its position, softly, until it is heard again.

#include <cmath>
#include <limits>

#include "plant/hydraulic_joint.hpp"
#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace force_lost_test {

using namespace testing;
using signals::JointState;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Tracks for a step, then reads no force.
Bench without_force() {
  Bench bench = Bench::tracking();
  bench.step();
  bench.inputs.sensors.force_N_or_Nm = kNan;
  return bench;
}

TEST(ForceLost, DampsAtOnceAndSaysSo) {
  Bench bench = without_force();
  const auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.state, JointState::kDamping);
  EXPECT_TRUE(FaultSet(outputs.valve.faults).has(Fault::kForceLost));
  EXPECT_FALSE(FaultSet(outputs.valve.faults).has(Fault::kSensorsStale));
  EXPECT_EQ(outputs.valve.generation, 0u) << "no gains act";
  EXPECT_EQ(outputs.valve.valve_current_A, 0.0) << "it has not moved yet";
}

TEST(ForceLost, DrivesBackToWhereTheForceWasLost) {
  Bench bench = without_force();
  const double held = bench.inputs.sensors.position_m_or_rad;
  bench.step();
  for (const double moved_m : {0.002, -0.002}) {
    bench.inputs.sensors.position_m_or_rad = held + moved_m;
    const double rate = hyq().safety.position_damping_1_s;
    const control::Normalisation& unit = bench.joint.normalisation;
    EXPECT_DOUBLE_EQ(bench.step().valve.valve_current_A,
                     -rate * ((held + moved_m) - held) / unit.velocity * unit.current_A);
  }
}

TEST(ForceLost, TracksAgainAfterTenGoodReadings) {
  Bench bench = without_force();
  bench.step();
  bench.inputs.sensors.force_N_or_Nm = 0.0;
  for (int good = 1; good < hyq().safety.recovery_samples; ++good) {
    EXPECT_EQ(bench.state(), JointState::kDamping) << good;
  }
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(ForceLost, IsNoReasonToMoveWithoutAPosition) {
  Bench bench = without_force();
  bench.step();
  bench.inputs.sensors.position_m_or_rad = kNan;
  expect_null(bench.step(), Fault::kSensorsStale);
}

TEST(ForceLost, CommandsThatStopChangeNothingUntilTheyTrip) {
  Bench bench = without_force();
  bench.step();
  bench.inputs.command_age_s = 0.02;
  EXPECT_EQ(bench.state(), JointState::kDamping);
  bench.inputs.command_age_s = 0.06;
  expect_null(bench.step(), Fault::kTripped);
}

class ForceLostUnder : public ::testing::TestWithParam<plant::LoadParams robot::Joint::*> {};

TEST_P(ForceLostUnder, HoldsAgainstALoadAndComesBackWithoutRinging) {
  Bench bench = Bench::tracking();
  const double home = bench.joint.linkage.position(bench.joint.home_angle_rad);
  auto joint = plant::HydraulicJoint::create(bench.joint.actuator, bench.joint.*GetParam(), {.position = home});
  ASSERT_TRUE(joint.ok()) << joint.error().message;
  const auto tick = [&](double external_force_N) {
    const plant::State state = joint.value().state();
    bench.inputs.sensors.position_m_or_rad = state.position;
    bench.inputs.sensors.velocity_m_s_or_rad_s = state.velocity;
    const double current_A = bench.step().valve.valve_current_A;
    joint.value().step(current_A, external_force_N, hyq().period_s);
    return joint.value().state();
  };
  tick(0.0);
  bench.inputs.sensors.force_N_or_Nm = kNan;
  const double held = joint.value().state().position;
  constexpr double kPush_N = 400.0;
  double furthest_m = 0.0;
  for (int i = 0; i < 500; ++i) {
    furthest_m = std::max(furthest_m, std::abs(tick(kPush_N).position - held));
  }
  EXPECT_LT(furthest_m, 0.01) << "a leg that loses a load cell does not give way";
  double speed = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const plant::State state = tick(0.0);
    speed = i < 1900 ? 0.0 : std::max(speed, std::abs(state.velocity));
  }
  EXPECT_NEAR(joint.value().state().position, held, 2e-4);
  EXPECT_LT(speed, 1e-3) << "rings";
}

INSTANTIATE_TEST_SUITE_P(Either, ForceLostUnder,
                         ::testing::Values(&robot::Joint::swing_load, &robot::Joint::stance_load));

}  // namespace force_lost_test
}  // namespace farrier::joint_node
