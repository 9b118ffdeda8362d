#include <cmath>
#include <limits>

#include "tests/unit/joint_node/bench.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace gains_test {

using namespace testing;
using signals::JointState;
using signals::Phase;

constexpr auto kSwing = Phase::kSwing;
constexpr auto kStance = Phase::kStance;

signals::JointControllerGains swing_design(const Bench& bench, Phase phase, std::uint32_t generation,
                                           Tick effective_tick) {
  auto signal =
      wire_gains::pack_gains(bench.joint.number, phase, 1, generation, design(bench.joint, bench.joint.swing_load));
  signal.effective_tick = effective_tick;
  return signal;
}

TEST(JointNode, PutsGainsIntoEffectAtTheirEffectiveTick) {
  Bench bench = Bench::tracking();
  bench.offer(swing_design(bench, Phase::kStance, 3, 5));
  EXPECT_EQ(bench.step_to(4).valve.generation, 2u);
  EXPECT_EQ(bench.step().valve.generation, 3u);
}

TEST(JointNode, TellsWhichGenerationActedInBothOutputs) {
  Bench bench = Bench::tracking();
  const auto outputs = bench.step();
  EXPECT_EQ(outputs.valve.generation, 2u);
  EXPECT_EQ(outputs.measurement.generation, 2u);
  EXPECT_EQ(outputs.valve.phase, kStance);
}

TEST(JointNode, KeepsItsGainsWhenAnOlderGenerationComes) {
  Bench bench = Bench::tracking();
  const auto newer = swing_design(bench, Phase::kStance, 7, 0);
  EXPECT_TRUE(bench.node.store_gains(newer, wire_gains::unpack_gains(newer)));
  for (const std::uint32_t generation : {7u, 6u, 1u}) {
    const auto older = gains_of(bench.joint, Phase::kStance, generation);
    EXPECT_FALSE(bench.node.store_gains(older, wire_gains::unpack_gains(older)));
  }
  EXPECT_EQ(bench.step().valve.generation, 7u);
}

TEST(JointNode, TakesGainsOfALaterSupervisorWhateverTheirGeneration) {
  Bench bench = Bench::tracking();
  bench.offer(gains_of(bench.joint, Phase::kStance, 9));
  EXPECT_EQ(bench.step().valve.generation, 9u);
  auto later = swing_design(bench, Phase::kStance, 3, 0);
  later.authority = 2;
  bench.offer(later);
  EXPECT_EQ(bench.step().valve.generation, 3u) << "the new supervisor never heard of 9";
  bench.offer(gains_of(bench.joint, Phase::kStance, 10));
  EXPECT_EQ(bench.step().valve.generation, 3u) << "of a supervisor that was replaced";
}

TEST(JointNode, GoesOnUnmovedWhenALaterSupervisorWritesTheSameGainsAgain) {
  Bench once = Bench::tracking();
  Bench again = Bench::tracking();
  for (Bench* bench : {&once, &again}) {
    bench->inputs.sensors.force_N_or_Nm = 40.0;
    bench->step_to(20);
  }
  auto rewritten = gains_of(again.joint, Phase::kStance, 2);
  rewritten.authority = 2;
  again.offer(rewritten);
  for (int i = 0; i < 20; ++i) {
    EXPECT_NEAR(again.step().valve.valve_current_A, once.step().valve.valve_current_A,
                1e-12 * once.joint.actuator.valve_current_max_A);
  }
}

TEST(JointNode, TakesNoGainsOfASupervisorThatHasBeenReplaced) {
  Bench bench = Bench::tracking();
  auto gains = swing_design(bench, Phase::kStance, 3, 0);
  gains.authority = 2;
  EXPECT_TRUE(bench.node.store_gains(gains, wire_gains::unpack_gains(gains)));
  for (const Phase phase : {Phase::kSwing, Phase::kStance}) {
    auto replaced = gains_of(bench.joint, phase, 9);
    replaced.authority = 1;
    EXPECT_FALSE(bench.node.store_gains(replaced, wire_gains::unpack_gains(replaced)));
  }
  EXPECT_EQ(bench.step().valve.generation, 3u);
}

TEST(JointNode, KeepsGainsThatAreNotYetInEffectWhenAnOlderGenerationComes) {
  Bench bench = Bench::tracking();
  bench.offer(swing_design(bench, Phase::kStance, 4, 5));
  bench.offer(swing_design(bench, Phase::kStance, 3, 2));
  EXPECT_EQ(bench.step_to(4).valve.generation, 2u);
  EXPECT_EQ(bench.step().valve.generation, 4u);
}

// In lock-step gains issued in tick k may come before or after a joint steps tick k; they must not displace what
// is due before them.
TEST(JointNode, ActsWithTheSameGainsWhetherAnUpdateComesEarlyOrLate) {
  Bench early = Bench::tracking();
  Bench late = Bench::tracking();
  const auto first = swing_design(early, Phase::kStance, 3, 4);
  const auto second = swing_design(early, Phase::kStance, 4, 6);
  early.offer(first);
  early.offer(second);
  late.offer(first);
  for (const std::uint32_t generation : {2u, 2u, 2u, 2u, 3u, 3u, 4u, 4u}) {
    if (late.next_tick == 5) {
      late.offer(second);
    }
    EXPECT_EQ(early.step().valve.generation, generation);
    EXPECT_EQ(late.step().valve.generation, generation);
  }
}

TEST(JointNode, ActsOnAsIfNothingHadComeWhenAnUpdateIsRefused) {
  Bench bench = Bench::tracking();
  Bench undisturbed = Bench::tracking();
  auto broken = gains_of(bench.joint, Phase::kStance, 3);
  broken.k_force = std::numeric_limits<double>::quiet_NaN();
  bench.offer(broken);
  bench.inputs.command.torque_ff_Nm = undisturbed.inputs.command.torque_ff_Nm = 7;
  for (int i = 0; i < 20; ++i) {
    const auto outputs = bench.step();
    EXPECT_EQ(outputs.valve.valve_current_A, undisturbed.step().valve.valve_current_A);
    EXPECT_EQ(outputs.valve.generation, 2u);
    EXPECT_EQ(outputs.valve.state, JointState::kTracking);
    EXPECT_TRUE(has(outputs, Fault::kGainsRefused));
  }
}

TEST(JointNode, ForgetsARefusalWithTheNextGoodGains) {
  Bench bench = Bench::tracking();
  bench.node.refuse_gains(gains_of(bench.joint, Phase::kStance, 3));
  EXPECT_TRUE(has(bench.step(), Fault::kGainsRefused));
  bench.offer(gains_of(bench.joint, Phase::kStance, 4));
  EXPECT_FALSE(has(bench.step(), Fault::kGainsRefused));
}

TEST(JointNode, StaysNullWhenItsFirstGainsAreRefused) {
  Bench bench;
  bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  auto unstable = gains_of(bench.joint, Phase::kStance, 1);
  unstable.k_force = -unstable.k_force;
  bench.offer(unstable);
  const auto outputs = bench.step();
  expect_null(outputs, Fault::kNoGains);
  EXPECT_TRUE(has(outputs, Fault::kGainsRefused));
}

TEST(JointNode, ChangesSlotAtTheAnnouncedTick) {
  Bench bench = Bench::tracking();
  bench.announce(Phase::kSwing, 1, 5);
  bench.announce(Phase::kStance, 2, 8);
  for (Tick tick = 0; tick < 12; ++tick) {
    const auto outputs = bench.step();
    const bool swings = tick >= 5 && tick < 8;
    EXPECT_EQ(outputs.valve.phase, swings ? kSwing : kStance) << "tick " << tick;
    EXPECT_EQ(outputs.valve.generation, swings ? 1u : 2u) << "tick " << tick;
  }
}

TEST(JointNode, FollowsTheNewestDueAnnouncementWhateverTheirOrder) {
  Bench bench = Bench::tracking();
  bench.announce(Phase::kStance, 2, 2);
  bench.announce(Phase::kSwing, 1, 1);
  bench.announce(Phase::kSwing, 3, 9);
  EXPECT_EQ(bench.step_to(5).valve.phase, kStance);
  EXPECT_EQ(bench.step_to(9).valve.phase, kSwing);
}

TEST(JointNode, FollowsAnAnnouncementThatCameAfterItsTick) {
  Bench bench = Bench::tracking();
  bench.step_to(10);
  bench.announce(Phase::kSwing, 1, 8);
  EXPECT_EQ(bench.step().valve.phase, kSwing);
}

TEST(JointNode, KeepsTrackThroughManyStrides) {
  Bench bench = Bench::tracking();
  for (std::uint32_t count = 1; count <= 40; ++count) {
    const Phase phase = count % 2 == 1 ? Phase::kSwing : Phase::kStance;
    bench.announce(phase, count, 10 * count);
    EXPECT_EQ(bench.step_to(10 * count - 1).valve.phase, phase == Phase::kSwing ? kStance : kSwing);
    EXPECT_EQ(bench.step().valve.phase, phase);
  }
}

TEST(JointNode, IgnoresAnAnnouncementOfAPhaseThereIsNot) {
  Bench bench = Bench::tracking();
  bench.announce(static_cast<Phase>(7), 1, 0);
  EXPECT_EQ(bench.step().valve.phase, kStance);
}

TEST(JointNode, ChangesGainsWithoutABump) {
  Bench bench = Bench::tracking();
  bench.offer(swing_design(bench, Phase::kSwing, 3, 0));
  bench.inputs.command.torque_ff_Nm = 2;
  bench.inputs.sensors.force_N_or_Nm = bench.joint.linkage.force(bench.angle(), 1.9);
  bench.inputs.sensors.velocity_m_s_or_rad_s = 0.01;
  bench.announce(Phase::kSwing, 1, 10);
  const double before_A = bench.step_to(9).valve.valve_current_A;
  const auto after = bench.step();
  ASSERT_EQ(after.valve.generation, 3u);
  ASSERT_LT(std::abs(before_A), bench.joint.actuator.valve_current_max_A) << "saturated: says nothing";
  ASSERT_NE(before_A, 0.0);
  // Six contributions of up to a hundred times the valve's current are added up.
  const double rounding_A = 600 * bench.joint.actuator.valve_current_max_A * std::numeric_limits<double>::epsilon();
  EXPECT_NEAR(after.valve.valve_current_A, before_A, rounding_A);
}

TEST(JointNode, ChangesSlotsThoughBothHoldTheSameGeneration) {
  Bench changing;
  changing.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  changing.offer(gains_of(changing.joint, Phase::kStance, 1));
  changing.offer(swing_design(changing, Phase::kSwing, 1, 0));
  Bench staying = changing;
  changing.announce(Phase::kSwing, 1, 5);
  changing.inputs.command.torque_ff_Nm = staying.inputs.command.torque_ff_Nm = 2;
  changing.step_to(5);
  staying.step_to(5);
  EXPECT_NE(changing.step().valve.valve_current_A, staying.step().valve.valve_current_A);
}

TEST(JointNode, KnowsTheNewestGenerationItHoldsActingOrNot) {
  Bench bench;
  EXPECT_EQ(bench.node.newest_generation(), 0u);
  bench.offer(gains_of(bench.joint, Phase::kStance, 5, 100));
  EXPECT_EQ(bench.node.newest_generation(), 5u);
  bench.offer(gains_of(bench.joint, Phase::kSwing, 6, 100));
  EXPECT_EQ(bench.node.newest_generation(), 6u);
}

}  // namespace gains_test
}  // namespace farrier::joint_node
