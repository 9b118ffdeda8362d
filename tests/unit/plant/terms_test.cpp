#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "test_effects.hpp"
#include "tests/support/allocation_guard.hpp"

namespace farrier::plant {
namespace terms_test {

using test::effect_of;
using test::joint_with;
using test::kPeriod_s;
using test::same;

const ActuatorParams kCylinder = test::hyq_cylinder();
const LoadParams kLoad = test::swing_load();

ActiveEffect with_first(EffectId id, double fitted) {
  const Scales scales(kCylinder, kLoad);
  ActiveEffect effect = effect_of(effect_info(id).name, {}, kCylinder, kLoad);
  effect.values[0] = scales.value(effect_info(id).parameters[0], fitted);
  return effect;
}

/// Every effect in the plant, each as large as its fit begins.
std::vector<ActiveEffect> everything() {
  std::vector<ActiveEffect> effects;
  for (EffectId id = 0; id < kEffectCount; ++id) {
    effects.push_back(with_first(id, effect_info(id).parameters[0].starts[1]));
  }
  return effects;
}

class EveryEffect : public testing::TestWithParam<EffectId> {};

TEST_P(EveryEffect, OfNoSizeLeavesTheNominalJoint) {
  const Parameter& size = effect_info(GetParam()).parameters[0];
  const double least = std::clamp(Scales(kCylinder, kLoad).neutral(size), size.low, size.high);
  HydraulicJoint with = joint_with(kCylinder, kLoad, {with_first(GetParam(), least)});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  test::ValveNoise noise(0.5, 0.02);
  double most_m_s = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    const double current = noise.next(kCylinder, nominal.state().position);
    with.step(current, 30.0, kPeriod_s);
    nominal.step(current, 30.0, kPeriod_s);
    most_m_s = std::max(most_m_s, std::abs(nominal.state().velocity));
    // The fastest spool that there is lags 14 us, a hundredth of a tick, which costs the first jumps 4 % of their way.
    ASSERT_NEAR(with.state().velocity, nominal.state().velocity, 0.05 * std::max(most_m_s, 0.02)) << "tick " << tick;
    ASSERT_NEAR(with.state().position, nominal.state().position, 1e-3 * kCylinder.stroke) << "tick " << tick;
  }
  EXPECT_GT(most_m_s, 0.1);
}

TEST_P(EveryEffect, OfAnySizeStaysPhysicalAndDoesNotAllocate) {
  const Parameter& size = effect_info(GetParam()).parameters[0];
  for (const double fitted : {size.starts[1], size.high}) {
    const ActiveEffect effect = with_first(GetParam(), fitted);
    const LoadParams load = loads_with_effects({kLoad, kLoad}, kCylinder, std::span(&effect, 1)).swing;
    auto made = HydraulicJoint::create(kCylinder, load, equilibrium(kCylinder, kLoad, 0.04, 0.0),
                                       HydraulicJoint::kDefaultTolerance, std::span(&effect, 1));
    ASSERT_TRUE(made.ok()) << made.error().message;
    HydraulicJoint joint = made.value();
    test::ValveNoise noise(1.0, 0.5);
    const farrier::test::AllocationGuard guard;
    for (int tick = 0; tick < 300; ++tick) {
      const StepReport report = joint.step(noise.next(kCylinder, joint.state().position), 50.0, kPeriod_s);
      ASSERT_GE(std::min(joint.state().pressure_a_Pa, joint.state().pressure_b_Pa), 0.0);
      ASSERT_TRUE(std::isfinite(joint.load_cell_force()) && std::isfinite(joint.state().velocity));
      ASSERT_LE(report.substeps, 3 * static_cast<int>(2.0 * kPeriod_s / HydraulicJoint::kShortestSubstep_s));
    }
    joint.set_load(test::stance_load());
    EXPECT_EQ(guard.allocations(), 0u);
  }
}

TEST_P(EveryEffect, OfThePlantShows) {
  const Side side = effect_info(GetParam()).side;
  const ActiveEffect effect = with_first(GetParam(), effect_info(GetParam()).parameters[0].starts[1]);
  HydraulicJoint with = joint_with(kCylinder, kLoad, {effect});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  double most_N = 0.0;
  for (int tick = 0; tick < 200; ++tick) {
    const double current = 0.004 * std::sin(0.05 * tick) + 5e-4;
    with.step(current, 200.0, kPeriod_s);
    nominal.step(current, 200.0, kPeriod_s);
    most_N = std::max(most_N, std::abs(with.load_cell_force() - nominal.load_cell_force()));
  }
  if (side == Side::kForceSensor || side == Side::kVelocitySensor) {
    EXPECT_EQ(most_N, 0.0) << "effects of sensors are the sensors'";
  } else if (GetParam() == effect_id<EndStop>()) {
    EXPECT_TRUE(same(with, nominal)) << "a stop that is not reached does nothing";
  } else {
    EXPECT_GT(most_N, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Terms, EveryEffect, testing::Range(EffectId{0}, kEffectCount),
                         [](const auto& param_info) { return std::string(effect_info(param_info.param).name); });

TEST(EffectsTogether, StayPhysicalUnderViolentValveNoise) {
  HydraulicJoint joint = joint_with(kCylinder, kLoad, everything());
  test::ValveNoise noise(2.0, 1.0);
  for (int tick = 0; tick < 2000; ++tick) {
    joint.step(noise.next(kCylinder, joint.state().position), 0.0, kPeriod_s);
    ASSERT_GE(std::min(joint.state().pressure_a_Pa, joint.state().pressure_b_Pa), 0.0);
    ASSERT_TRUE(std::isfinite(joint.load_cell_force()));
  }
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  HydraulicJoint null_valve = joint;
  EXPECT_TRUE(joint.step(kNan, kNan, kPeriod_s).input_refused);
  null_valve.step(0.0, 0.0, kPeriod_s);
  EXPECT_TRUE(same(joint, null_valve));
}

TEST(EffectsTogether, ComeCloserWithATighterTolerance) {
  HydraulicJoint finest = joint_with(kCylinder, kLoad, everything(), 1e-11);
  HydraulicJoint fine = joint_with(kCylinder, kLoad, everything(), 1e-8);
  HydraulicJoint coarse = joint_with(kCylinder, kLoad, everything(), 1e-5);
  double fine_worst_m = 0.0;
  double coarse_worst_m = 0.0;
  test::ValveNoise noise(0.1, 0.01);
  for (int tick = 0; tick < 200; ++tick) {
    const double current = noise.next(kCylinder, finest.state().position);
    for (HydraulicJoint* joint : {&finest, &fine, &coarse}) {
      joint->step(current, 0.0, kPeriod_s);
    }
    fine_worst_m = std::max(fine_worst_m, std::abs(fine.state().position - finest.state().position));
    coarse_worst_m = std::max(coarse_worst_m, std::abs(coarse.state().position - finest.state().position));
  }
  EXPECT_LT(fine_worst_m, 0.1 * coarse_worst_m);
  EXPECT_LT(coarse_worst_m, 1e-5 * 200 * kCylinder.stroke);
}

// A blow into a shut joint with all that stores or takes energy: what comes back is less than what was put in.
TEST(EffectsTogether, GiveNoEnergyToAShutJoint) {
  std::vector<ActiveEffect> effects;
  for (const char* name : {"internal_leakage", "air_entrainment", "backlash", "piston_friction", "load_friction"}) {
    effects.push_back(with_first(find_effect(name), effect_info(find_effect(name)).parameters[0].starts[1]));
  }
  State start = equilibrium(kCylinder, kLoad, 0.04, 0.0);
  start.velocity = 0.3;
  HydraulicJoint joint = HydraulicJoint::create(kCylinder, kLoad, start, 1e-8, effects).value();
  double most_m_s = 0.3;
  for (int tick = 0; tick < 1000; ++tick) {
    joint.step(0.0, 0.0, 1e-4);
    ASSERT_LT(std::abs(joint.state().velocity), most_m_s);
    most_m_s = tick == 100 ? 0.1 : most_m_s;
  }
  EXPECT_LT(std::abs(joint.state().velocity), 1e-3);
}

TEST(Effects, AreRefusedByNameWhereNoMachineHasTheirNumbers) {
  ActiveEffect bad = effect_of("valve_dynamics", {-100.0}, kCylinder, kLoad);
  const ActiveEffect leak = effect_of("internal_leakage", {std::nan("")}, kCylinder, kLoad);
  const State rest = equilibrium(kCylinder, kLoad, 0.04, 0.0);
  const std::array effects{bad, leak, leak};
  const auto joint = HydraulicJoint::create(kCylinder, kLoad, rest, 1e-6, effects);
  ASSERT_FALSE(joint.ok());
  for (const char* word : {"valve_dynamics: natural_frequency_rad_s", "internal_leakage: coefficient", "there twice"}) {
    EXPECT_NE(joint.error().message.find(word), std::string::npos) << word << " missing: " << joint.error().message;
  }
  // A stop of 8e7 N/m whose damper takes 20 ms to let go of it: 6e5 1/s on 2.8 kg.
  const ActiveEffect stiff = effect_of("end_stop", {0.01, 8e7, 0.02}, kCylinder, kLoad);
  const auto too_fast = HydraulicJoint::create(kCylinder, kLoad, rest, 1e-6, std::span(&stiff, 1));
  ASSERT_FALSE(too_fast.ok());
  EXPECT_NE(too_fast.error().message.find("fastest rate"), std::string::npos) << too_fast.error().message;
  bad.id = kEffectCount;
  EXPECT_FALSE(HydraulicJoint::create(kCylinder, kLoad, rest, 1e-6, std::span(&bad, 1)).ok());
}

TEST(Backlash, SteppedItTravelsItsPlayAndTheBendOfBothFlanks) {
  constexpr double kPlay = 0.004;
  constexpr double kOil = 1e7;
  const Scales scales(kCylinder, kLoad);
  const double drive = 0.1 * scales.of(Scale::kForce);
  const double flanks = 1e3 * scales.of(Scale::kStiffness);
  const std::array fitted{kPlay / scales.of(Scale::kLength), scales.of(Scale::kStiffness) / flanks};
  Backlash<double> play(fitted.data(), scales, 0.0);
  double travel = 0.0;
  for (int step = 0; step < 1000; ++step) {
    PlayMoment<double> now{step == 0 ? drive : -drive, kCylinder.piston_damping, kOil, 1e-3, 0.0};
    play.on_play(now);
    travel += now.moved;
  }
  const double expected = -(kPlay + 2.0 * drive / flanks);
  EXPECT_NEAR(travel, expected, 1e-6 * kPlay);
}

}  // namespace terms_test
}  // namespace farrier::plant
