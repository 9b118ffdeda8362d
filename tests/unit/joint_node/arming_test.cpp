#include <limits>

#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace arming_test {

using namespace testing;
using signals::JointState;
using signals::Mode;
using signals::Phase;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Bench with_gains() {
  Bench bench;
  bench.offer(gains_of(bench.joint, Phase::kSwing, 1));
  bench.offer(gains_of(bench.joint, Phase::kStance, 2));
  return bench;
}

TEST(JointNode, StaysNullUntilArmed) {
  Bench bench = with_gains();
  for (int i = 0; i < 20; ++i) {
    expect_null(bench.step(), Fault::kDisarmed);
  }
}

TEST(JointNode, ArmsFromTheEffectiveTickOfTheMode) {
  Bench bench = with_gains();
  bench.node.set_mode(mode_of(Mode::kArmed, 1, 5));
  expect_null(bench.step_to(4), Fault::kDisarmed);
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, IgnoresAModeOfAnotherSession) {
  Bench bench = with_gains();
  bench.node.set_mode(mode_of(Mode::kArmed, 1, 0, kSession + 1));
  expect_null(bench.step(), Fault::kDisarmed);
}

TEST(JointNode, IgnoresAModeItHasSuperseded) {
  Bench bench = with_gains();
  bench.node.set_mode(mode_of(Mode::kStopped, 2));
  bench.step();
  bench.node.set_mode(mode_of(Mode::kArmed, 1));
  expect_null(bench.step(), Fault::kDisarmed);
}

TEST(JointNode, DoesNotArmOnAnIdleMode) {
  Bench bench = with_gains();
  bench.node.set_mode(mode_of(Mode::kIdle, 1));
  expect_null(bench.step(), Fault::kDisarmed);
}

TEST(JointNode, NullsValveWhenTheRobotIsStopped) {
  Bench bench = Bench::tracking();
  EXPECT_EQ(bench.state(), JointState::kTracking);
  bench.node.set_mode(mode_of(Mode::kStopped, 2, 3));
  EXPECT_EQ(bench.state(), JointState::kTracking) << "not yet in effect";
  EXPECT_EQ(bench.state(), JointState::kTracking);
  expect_null(bench.step(), Fault::kDisarmed);
}

TEST(JointNode, StopsAtTheTickOfTheStopThoughTheNextModeIsKnown) {
  Bench bench = Bench::tracking();
  bench.node.set_mode(mode_of(Mode::kStopped, 2, 3));
  bench.node.set_mode(mode_of(Mode::kArmed, 3, 5));
  EXPECT_EQ(static_cast<JointState>(bench.step_to(2).valve.state), JointState::kTracking);
  expect_null(bench.step(), Fault::kDisarmed);
  expect_null(bench.step(), Fault::kDisarmed);
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, StaysNullWithoutGains) {
  Bench bench;
  bench.node.set_mode(mode_of(Mode::kArmed, 1));
  expect_null(bench.step(), Fault::kNoGains);
}

TEST(JointNode, StaysNullWithoutGainsForThePhaseItIsIn) {
  Bench bench;
  bench.node.set_mode(mode_of(Mode::kArmed, 1));
  bench.offer(gains_of(bench.joint, Phase::kStance, 1));
  bench.announce(Phase::kSwing, 1, 2);
  bench.step();
  EXPECT_EQ(bench.state(), JointState::kTracking);
  expect_null(bench.step(), Fault::kNoGains);
}

TEST(JointNode, TripsWhenTheCommandIsOlderThanFiftyMilliseconds) {
  Bench bench = Bench::tracking();
  bench.step();
  bench.inputs.command_age_s = 0.050;
  EXPECT_EQ(bench.state(), JointState::kDamping);
  bench.inputs.command_age_s = 0.0501;
  expect_null(bench.step(), Fault::kTripped);
}

TEST(JointNode, TripsAfterAPauseOfFiftyMillisecondsEvenIfNewerCommandsHaveArrived) {
  Bench bench = Bench::tracking();
  bench.step();
  bench.inputs.since_last_step_s = 0.050;
  EXPECT_EQ(bench.state(), JointState::kTracking);
  bench.inputs.since_last_step_s = 0.0501;
  expect_null(bench.step(), Fault::kTripped);
}

TEST(JointNode, StaysTrippedWhenTheCommandComesBack) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.060;
  bench.step();
  bench.inputs.command_age_s = 0;
  for (int i = 0; i < 100; ++i) {
    expect_null(bench.step(), Fault::kTripped);
  }
}

TEST(JointNode, RearmsAfterATripOnlyWithANewerModeOfItsSession) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.060;
  bench.step();
  bench.inputs.command_age_s = 0;
  bench.node.set_mode(mode_of(Mode::kArmed, 1));
  expect_null(bench.step(), Fault::kTripped);
  bench.node.set_mode(mode_of(Mode::kArmed, 9, 0, kSession + 1));
  expect_null(bench.step(), Fault::kTripped);
  bench.node.set_mode(mode_of(Mode::kArmed, 2, bench.next_tick + 1));
  expect_null(bench.step(), Fault::kTripped);
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, StaysTrippedThroughAStopUntilArmedAgain) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.060;
  bench.step();
  bench.inputs.command_age_s = 0;
  bench.node.set_mode(mode_of(Mode::kStopped, 2));
  expect_null(bench.step(), Fault::kTripped);
  bench.node.set_mode(mode_of(Mode::kArmed, 3));
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, TripsAgainWhenRearmedWhileTheCommandIsStillLost) {
  Bench bench = Bench::tracking();
  bench.inputs.command_age_s = 0.060;
  bench.step();
  bench.node.set_mode(mode_of(Mode::kArmed, 2));
  expect_null(bench.step(), Fault::kTripped);
  bench.inputs.command_age_s = 0;
  expect_null(bench.step(), Fault::kTripped);
}

TEST(JointNode, DoesNotTripWhileDisarmed) {
  Bench bench = with_gains();
  bench.inputs.command_age_s = 0.060;
  EXPECT_FALSE(has(bench.step(), Fault::kTripped));
  bench.inputs.command_age_s = 0;
  bench.node.set_mode(mode_of(Mode::kArmed, 1));
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNode, DampsInsteadOfTrippingBeforeTheFirstCommand) {
  Bench bench = Bench::tracking();
  bench.inputs.tick = bench.inputs.sensors.tick = 0;
  bench.inputs.command = {};
  bench.inputs.command_age_s = kInfinity;
  const auto outputs = bench.node.step(bench.inputs);
  EXPECT_EQ(outputs.valve.state, JointState::kDamping);
  EXPECT_FALSE(has(outputs, Fault::kTripped));
}

}  // namespace arming_test
}  // namespace farrier::joint_node
