// A joint whose robot file says flow_inversion: physics in place of gains, everything else as ever.

#include <cmath>
#include <limits>

#include "plant/hydraulic_joint.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/joint_node/bench.hpp"
#include "wire_gains/wire_gains.hpp"

namespace farrier::joint_node {
namespace flow_inversion_test {

using namespace testing;
using signals::JointControllerGains;
using signals::JointState;
using signals::Phase;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const robot::Joint& inverting() {
  static const robot::Joint joint = [] {
    robot::Joint changed = joint_named("lf_kfe");
    changed.kind = control::Kind::kFlowInversion;
    return changed;
  }();
  return joint;
}

JointControllerGains physics_of(const plant::LoadParams& load, Phase phase, std::uint32_t generation,
                                Tick effective_tick = 0) {
  return wire_gains::with_physics(gains_of(inverting(), phase, generation, effective_tick),
                                  plant::nominal_physics(inverting().actuator, load));
}

Bench armed() {
  Bench bench(inverting());
  bench.node.set_mode(mode_of(signals::Mode::kArmed, 1));
  return bench;
}

Bench tracking() {
  Bench bench = armed();
  bench.offer(physics_of(inverting().swing_load, Phase::kSwing, 1));
  bench.offer(physics_of(inverting().stance_load, Phase::kStance, 2));
  return bench;
}

TEST(JointNodeFlowInversion, StaysNullUntilItHasPhysicsForItsPhase) {
  Bench bench = armed();
  expect_null(bench.step(), Fault::kNoGains);
  bench.offer(physics_of(inverting().swing_load, Phase::kSwing, 1));
  expect_null(bench.step(), Fault::kNoGains);
  bench.offer(physics_of(inverting().stance_load, Phase::kStance, 2));
  EXPECT_EQ(bench.state(), JointState::kTracking);
}

TEST(JointNodeFlowInversion, RefusesGainsWithoutPhysicsAndWithPhysicsThatNoJointHasByName) {
  const auto refusal = [](const JointControllerGains& signal) {
    const auto checked = check_gains(signal, control::Kind::kFlowInversion);
    return checked ? std::string("accepted") : checked.error().message;
  };
  EXPECT_EQ(refusal(gains_of(inverting(), Phase::kStance, 1)),
            "no physics, which a controller that inverts the flow law needs: give has_physics and physics");
  const JointControllerGains good = physics_of(inverting().stance_load, Phase::kStance, 1);
  EXPECT_EQ(refusal(good), "accepted");
  const char* names[] = {"load_mass",  "damping",      "coulomb", "stiffness", "bias_force",
                         "valve_gain", "bulk_modulus", "leakage", "overlap_A"};
  for (std::size_t i = 0; i < plant::kPhysicsCount; ++i) {
    JointControllerGains bad = good;
    bad.physics[i] = kNaN;
    EXPECT_EQ(refusal(bad), "physics is not finite");
    bad.physics[i] = -1.0;
    EXPECT_EQ(refusal(bad), i == plant::kBiasForce
                                ? std::string("accepted")
                                : std::string("physics: ") + names[i] + " is not finite or out of its range");
  }
  Bench bench = armed();
  bench.offer(gains_of(inverting(), Phase::kStance, 1));
  const auto outputs = bench.step();
  expect_null(outputs, Fault::kNoGains);
  EXPECT_TRUE(has(outputs, Fault::kGainsRefused));
}

TEST(JointNodeFlowInversion, TakesPhysicsWithGainsThatWouldNotHoldALinearLoop) {
  JointControllerGains signal = physics_of(inverting().stance_load, Phase::kStance, 1);
  signal.k_force = -1e3;
  EXPECT_FALSE(check_gains(signal, control::Kind::kLqr));
  EXPECT_TRUE(check_gains(signal, control::Kind::kFlowInversion)) << "they do not act";
}

/// The bench's joint as the plant of the flow law, with the force measured where the node wants it.
struct Loop {
  explicit Loop(Bench node) : bench(std::move(node)), plant(make()) {}

  plant::HydraulicJoint make() const {
    const robot::Joint& joint = bench.joint;
    const double home = joint.linkage.position(joint.home_angle_rad);
    return plant::HydraulicJoint::create(joint.actuator, joint.stance_load,
                                         plant::equilibrium(joint.actuator, joint.stance_load, home, 0.0))
        .value();
  }
  JointNode::Outputs step() {
    bench.inputs.sensors.position_m_or_rad = plant.state().position;
    bench.inputs.sensors.velocity_m_s_or_rad_s = plant.state().velocity;
    bench.inputs.sensors.force_N_or_Nm = plant.load_cell_force();
    const JointNode::Outputs outputs = bench.step();
    plant.step(outputs.valve.valve_current_A, 0.0, hyq().period_s);
    return outputs;
  }

  Bench bench;
  plant::HydraulicJoint plant;
};

// The leg gives way, so the reference falls from 440 N; once there, the force follows it to a hundredth of that.
TEST(JointNodeFlowInversion, FollowsTheForceItIsAskedForFromTwentyMillisecondsOn) {
  Loop loop(tracking());
  loop.bench.inputs.command.torque_ff_Nm = 20.0;
  double largest = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    const double force = loop.plant.load_cell_force();
    const auto outputs = loop.step();
    const double reference = outputs.valve.force_reference_N_or_Nm;
    largest = std::max(largest, std::abs(reference));
    if (tick >= 20) {
      EXPECT_NEAR(force, reference, 0.01 * largest) << tick;
      EXPECT_EQ(outputs.valve.faults, 0u);
      EXPECT_EQ(outputs.valve.generation, 2u);
    }
  }
}

// The outer loop's stiffness and damping are k / r^2 on the piston, with the lever r, and reach it in a tick. Their
// reference must not be led like a command, which would excite the leg against them.
TEST(JointNodeFlowInversion, HoldsALightLegUnderAStiffOuterLoopStill) {
  Bench bench = tracking();
  bench.announce(Phase::kSwing, 1, 0);
  Loop loop(std::move(bench));
  ASSERT_TRUE(loop.plant.set_load(inverting().swing_load));
  loop.bench.inputs.command.position_rad += 0.02;
  double moved = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    loop.step();
    moved = tick >= 300 ? std::max(moved, std::abs(loop.plant.state().velocity)) : moved;
  }
  EXPECT_LT(moved, 1e-3) << "m/s, a hundred milliseconds long";
  EXPECT_NEAR(loop.bench.angle(), loop.bench.inputs.command.position_rad, 1e-3);
}

TEST(JointNodeFlowInversion, ChangesSlotsWithoutABump) {
  Loop loop(tracking());
  loop.bench.inputs.command.torque_ff_Nm = 20.0;
  for (int tick = 0; tick < 100; ++tick) {
    loop.step();
  }
  // Physics of the other slot are those of the same load: nothing may come of the change itself.
  loop.bench.offer(physics_of(inverting().stance_load, Phase::kSwing, 3));
  Loop kept = loop;
  loop.bench.announce(Phase::kSwing, 1, loop.bench.next_tick + 1);
  for (int tick = 0; tick < 20; ++tick) {
    const auto changed = loop.step();
    const auto same = kept.step();
    EXPECT_NEAR(changed.valve.valve_current_A, same.valve.valve_current_A, 1e-12) << tick;
    EXPECT_EQ(changed.valve.generation, tick < 1 ? 2u : 3u);
  }
}

TEST(JointNodeFlowInversion, StaysWithinTheValveWhateverItIsAskedForAndSaysSo) {
  Bench bench = tracking();
  bench.step();
  bench.inputs.command.torque_ff_Nm = 1e3;
  bench.inputs.sensors.force_N_or_Nm = -4.0 * bench.joint.push_limit;
  const auto outputs = bench.step();
  EXPECT_EQ(std::abs(outputs.valve.valve_current_A), bench.joint.actuator.valve_current_max_A);
  EXPECT_TRUE(has(outputs, Fault::kValveSaturated));
}

TEST(JointNodeFlowInversion, NullsTheValveOnSensorsThatAreNotNumbersAndStartsAfresh) {
  Bench bench = tracking();
  bench.inputs.command.torque_ff_Nm = 20.0;
  bench.step();
  const double first_A = bench.step().valve.valve_current_A;
  EXPECT_NE(first_A, 0.0);
  for (double* sensor : {&bench.inputs.sensors.position_m_or_rad, &bench.inputs.sensors.velocity_m_s_or_rad_s}) {
    const double sound = *sensor;
    *sensor = kNaN;
    expect_null(bench.step(), Fault::kSensorsStale);
    *sensor = sound;
    const auto back = bench.step_to(bench.next_tick + hyq().safety.recovery_samples - 1);
    EXPECT_EQ(back.valve.state, JointState::kTracking);
    EXPECT_TRUE(std::isfinite(back.valve.valve_current_A));
  }
}

TEST(JointNodeFlowInversion, StepDoesNotAllocate) {
  Bench bench = tracking();
  bench.step();
  JointControllerGains update = physics_of(inverting().stance_load, Phase::kStance, 3, 5);
  const control::Gains gains = wire_gains::unpack_gains(update);
  const farrier::test::AllocationGuard guard;
  bench.node.store_gains(update, gains);
  for (int tick = 0; tick < 20; ++tick) {
    bench.step();
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace flow_inversion_test
}  // namespace farrier::joint_node
