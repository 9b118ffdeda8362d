#include <cmath>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/joint_node/bench.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace dither_test {

using namespace testing;
using signals::JointState;
using signals::Phase;

constexpr double kPercent = 0.2;
constexpr double kRounding = 1e-15;  // A: a few units in the last place of 10 mA

robot::Joint dithered(int hold_ticks = 1, const std::string& name = "lf_kfe") {
  robot::Joint joint = joint_named(name);
  joint.dither_percent = kPercent;
  joint.dither_hold_ticks = hold_ticks;
  return joint;
}

double amplitude_A(const robot::Joint& joint) { return 0.01 * kPercent * joint.actuator.valve_current_max_A; }

/// The dither of one tick, whatever was before: what a fresh node commands with it, less what it commands without.
double dither_at(const robot::Joint& joint, Tick tick) {
  Bench with = Bench::tracking(joint);
  Bench without = Bench::tracking(joint.name);
  with.next_tick = without.next_tick = tick;
  return with.step().valve.valve_current_A - without.step().valve.valve_current_A;
}

TEST(JointNode, AddsDitherOfEitherSignWhileItTracks) {
  const robot::Joint joint = dithered();
  int positive = 0;
  constexpr int kTicks = 400;
  for (Tick tick = 0; tick < kTicks; ++tick) {
    const double dither = dither_at(joint, tick);
    ASSERT_NEAR(std::abs(dither), amplitude_A(joint), kRounding) << "at tick " << tick;
    positive += dither > 0.0 ? 1 : 0;
  }
  const double kFourSigma = 4.0 * std::sqrt(kTicks / 4.0);  // of as many fair coins
  EXPECT_NEAR(positive, kTicks / 2.0, kFourSigma);
}

TEST(JointNode, HoldsTheSignOfItsDither) {
  constexpr int kHold = 5;
  const robot::Joint joint = dithered(kHold);
  int changes = 0;
  for (Tick tick = 0; tick < 40 * kHold; tick += kHold) {
    const bool positive = dither_at(joint, tick) > 0.0;
    for (Tick later = tick + 1; later < tick + kHold; ++later) {
      ASSERT_EQ(dither_at(joint, later) > 0.0, positive) << "at tick " << later;
    }
    changes += positive != (dither_at(joint, tick + kHold) > 0.0) ? 1 : 0;
  }
  EXPECT_GT(changes, 0);
}

TEST(JointNode, DithersEveryJointDifferently) {
  const robot::Joint one = dithered();
  const robot::Joint other = dithered(1, "rh_hfe");
  int differences = 0;
  for (Tick tick = 0; tick < 64; ++tick) {
    differences += (dither_at(one, tick) > 0.0) != (dither_at(other, tick) > 0.0) ? 1 : 0;
  }
  EXPECT_GT(differences, 0);
}

TEST(JointNode, SaysWhatItReallyCommandedWhenItDithers) {
  const robot::Joint joint = dithered();
  Bench bench = Bench::tracking(joint);
  for (int i = 0; i < 20; ++i) {
    const auto outputs = bench.step();
    EXPECT_EQ(outputs.measurement.valve_current_A, outputs.valve.valve_current_A);
  }
}

TEST(JointNode, DoesNotDitherUnlessItTracks) {
  const robot::Joint joint = dithered();
  Bench with = Bench::tracking(joint);
  Bench without = Bench::tracking();
  with.inputs.command_age_s = without.inputs.command_age_s = 0.01;
  for (int i = 0; i < 20; ++i) {
    const auto damped = with.step();
    ASSERT_EQ(damped.valve.state, JointState::kDamping);
    EXPECT_EQ(damped.valve.valve_current_A, without.step().valve.valve_current_A);
  }
  with.inputs.sensors_age_s = 1.0;
  expect_null(with.step(), Fault::kSensorsStale);
}

TEST(JointNode, DitherDoesNotAllocate) {
  const robot::Joint joint = dithered();
  Bench bench = Bench::tracking(joint);
  const test::AllocationGuard guard;
  for (int i = 0; i < 20; ++i) {
    bench.step();
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

// The feed-forward may step with the phase: touchdown puts the weight on the leg.
TEST(JointNode, LetsAReferenceThatStepsWithThePhaseThroughTheNewGains) {
  constexpr Tick kSwitch = 10;
  constexpr double kStep_Nm = 5.0;
  Bench bench = Bench::tracking();
  const control::Gains own = design(bench.joint, bench.joint.swing_load);
  auto swing = wire_gains::pack_gains(bench.joint.number, Phase::kSwing, 1, 3, own);
  bench.offer(swing);
  bench.announce(Phase::kSwing, 1, kSwitch);
  const auto before = bench.step_to(kSwitch - 1).valve;
  bench.inputs.command.torque_ff_Nm = kStep_Nm;
  const auto after = bench.step().valve;
  ASSERT_EQ(after.phase, Phase::kSwing);
  const double step = after.force_reference_N_or_Nm - before.force_reference_N_or_Nm;
  const control::Normalisation& n = own.normalisation;
  EXPECT_NEAR(after.valve_current_A - before.valve_current_A,
              n.current_A * (own.force + own.feed_forward) * step / n.force, kRounding);
}

}  // namespace dither_test
}  // namespace farrier::joint_node
