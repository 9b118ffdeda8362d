// A joint whose robot file has effects: sensors are corrected and the valve's effects compensated. The joint publishes
// the values that it read and sent.

#include <cmath>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/joint_node/bench.hpp"

namespace farrier::joint_node {
namespace effects_test {

using namespace testing;
using plant::effect_id;
using signals::JointState;

robot::Joint with(std::vector<plant::ActiveEffect> effects, const char* name = "lf_kfe") {
  robot::Joint joint = joint_named(name);
  joint.effects = std::move(effects);
  return joint;
}

plant::ActiveEffect effect(plant::EffectId id, const robot::Joint& joint) {
  const plant::Scales scales(joint.actuator, joint.swing_load);
  plant::ActiveEffect made{id, {}};
  for (std::size_t i = 0; i < made.info().parameters.size(); ++i) {
    made.values[i] = scales.value(made.info().parameters[i], made.info().parameters[i].starts[1]);
  }
  return made;
}

TEST(JointNode, SendsTheNullShiftLessThanTheControllerAsksFor) {
  constexpr double kShift_A = 2e-4;
  const robot::Joint shifted = with({{effect_id<plant::ValveBias>(), {kShift_A}}});
  Bench bench = Bench::tracking(shifted);
  Bench nominal = Bench::tracking();
  for (int k = 0; k < 10; ++k) {
    bench.inputs.command.torque_ff_Nm = nominal.inputs.command.torque_ff_Nm = k;
    const auto out = bench.step();
    EXPECT_DOUBLE_EQ(out.valve.valve_current_A, nominal.step().valve.valve_current_A - kShift_A);
    EXPECT_EQ(out.measurement.valve_current_A, out.valve.valve_current_A);
  }
}

TEST(JointNode, ControlsTheForceThatItsCellDistortsAndPublishesWhatItRead) {
  const robot::Joint distorted =
      with({{effect_id<plant::ForceSensorGain>(), {1.25}}, {effect_id<plant::ForceSensorOffset>(), {-40.0}}});
  Bench bench = Bench::tracking(distorted);
  Bench nominal = Bench::tracking();
  for (int k = 0; k < 10; ++k) {
    nominal.inputs.sensors.force_N_or_Nm = 30.0 * k;
    bench.inputs.sensors.force_N_or_Nm = 1.25 * 30.0 * k - 40.0;
    const auto out = bench.step();
    EXPECT_NEAR(out.valve.valve_current_A, nominal.step().valve.valve_current_A, 1e-12);
    EXPECT_EQ(out.measurement.force_N_or_Nm, bench.inputs.sensors.force_N_or_Nm);
  }
}

TEST(JointNode, FormsItsReferenceWithTheVelocityItBelievesIn) {
  const robot::Joint lagging = with({{effect_id<plant::VelocityFilterLag>(), {0.006}}});
  Bench bench = Bench::tracking(lagging);
  Bench nominal = Bench::tracking();
  bench.inputs.command.stiffness_Nm_rad = nominal.inputs.command.stiffness_Nm_rad = 0.0;
  constexpr double kSpeed_m_s = 0.1;
  nominal.inputs.sensors.velocity_m_s_or_rad_s = kSpeed_m_s;  // the lagging one says 0
  JointNode::Outputs out, expected;
  for (int k = 0; k < 60; ++k) {
    bench.inputs.sensors.position_m_or_rad += kSpeed_m_s * hyq().period_s;
    nominal.inputs.sensors.position_m_or_rad = bench.inputs.sensors.position_m_or_rad;
    out = bench.step();
    expected = nominal.step();
  }
  EXPECT_LT(std::abs(expected.valve.force_reference_N_or_Nm), joint_named("lf_kfe").pull_limit);
  EXPECT_NE(expected.valve.force_reference_N_or_Nm, 0.0);
  EXPECT_NEAR(out.valve.force_reference_N_or_Nm, expected.valve.force_reference_N_or_Nm,
              1e-6 * std::abs(expected.valve.force_reference_N_or_Nm));
}

TEST(JointNode, StaysBoundedAndDoesNotAllocateWithEveryEffectAndEveryController) {
  for (const control::Kind kind : {control::Kind::kLqr, control::Kind::kFeedbackLinearisation, control::Kind::kPid}) {
    robot::Joint joint = joint_named("lf_kfe");
    joint.kind = kind;
    for (const plant::EffectId id : control::kCompensatedEffects) {
      joint.effects.push_back(effect(id, joint));
    }
    Bench bench = Bench::tracking(joint);
    const test::AllocationGuard guard;
    int tracked = 0;
    for (int k = 0; k < 2000; ++k) {
      const double wild = k % 97 == 0 ? 1e300 : k % 89 == 0 ? -1e303 : 1.0;
      bench.inputs.sensors.force_N_or_Nm = 100.0 * std::sin(0.1 * k);
      bench.inputs.sensors.velocity_m_s_or_rad_s = wild * 0.1 * std::cos(0.1 * k);
      bench.inputs.command.torque_ff_Nm = 20.0 * std::sin(0.05 * k);
      const auto out = bench.step();
      ASSERT_TRUE(std::abs(out.valve.valve_current_A) <= joint.actuator.valve_current_max_A) << k;
      tracked += out.valve.state == JointState::kTracking ? 1 : 0;
    }
    EXPECT_EQ(guard.allocations(), 0u);
    EXPECT_EQ(tracked, 2000);
  }
}

TEST(JointNode, NullIsNullWhateverTheValve) {
  const robot::Joint shifted = with({{effect_id<plant::ValveBias>(), {2e-4}}});
  Bench bench(shifted);
  expect_null(bench.step(), Fault::kDisarmed);
}

}  // namespace effects_test
}  // namespace farrier::joint_node
