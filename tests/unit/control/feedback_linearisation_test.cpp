// The controller HyQ ran, on the nonlinear joint it inverts.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "control/law/feedback_linearisation.hpp"
#include "plant/terms/active_effect.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/plant/test_joints.hpp"

namespace farrier::control {
namespace feedback_linearisation_test {

using plant::test::hyq_cylinder;
using plant::test::kPeriod_s;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kMiddle_m = 0.04;

FeedbackLinearisation controller(const FeedbackLinearisationGains& gains = {}) {
  return {hyq_cylinder(), gains, kMiddle_m, kPeriod_s};
}

Measurement measured(const plant::HydraulicJoint& joint) {
  return {joint.state().position - kMiddle_m, joint.state().velocity, joint.load_cell_force()};
}

/// A piston on an immovable load under steady chamber pressures (3.19), (3.20) of one sign of the valve.
plant::HydraulicJoint held(const plant::ActuatorParams& a, double load_pressure_Pa, bool extends) {
  const double alpha = a.area_b / a.area_a;
  const double cube = alpha * alpha * alpha;
  const double to_a = extends ? a.return_pressure_Pa : a.supply_pressure_Pa;
  const double to_b = extends ? a.supply_pressure_Pa : a.return_pressure_Pa;
  plant::State state{.position = kMiddle_m, .velocity = 0.0};
  state.pressure_a_Pa = (load_pressure_Pa + alpha * to_a + cube * to_b) / (1.0 + cube);
  state.pressure_b_Pa = (alpha * alpha * (to_b - load_pressure_Pa) + to_a) / (1.0 + cube);
  return plant::HydraulicJoint::create(a, {.mass = 1e6, .damping = 0.0}, state).value();
}

TEST(FeedbackLinearisation, MakesTheForceRateItWantsWithTheOilThatItIsTold) {
  plant::ActuatorParams soft = hyq_cylinder();
  soft.bulk_modulus_Pa *= 0.25;
  constexpr double kShort_s = 1e-5, kError_N = 200.0;
  const FeedbackLinearisationGains proportional{.force_1_s = 400.0, .integral_1_s2 = 0.0, .velocity_compensation = 1.0};
  for (const bool told : {false, true}) {
    plant::HydraulicJoint joint = held(soft, 0.0, true);
    FeedbackLinearisation law = controller(proportional);
    if (told) {
      ASSERT_TRUE(law.set_physics(plant::nominal_physics(soft, {.mass = 1.0, .damping = 0.0})));
    }
    const double before = joint.hydraulic_force();
    joint.step(law.step(before + kError_N, {0.0, 0.0, before}).valve_current_A, 0.0, kShort_s);
    const double rate = (joint.hydraulic_force() - before) / kShort_s;
    const double wanted = proportional.force_1_s * kError_N;
    EXPECT_NEAR(rate, told ? wanted : 0.25 * wanted, 0.01 * wanted) << told;
  }
}

TEST(FeedbackLinearisation, MakesTheForceRateItWantsEitherWay) {
  // The plant's root is 0.25 % below sqrt at a drop of ten laminar pressures; here the drop is at least sixty. Over
  // 10 us the pressures move by a thousandth of the drop. Damping of the piston has no effect at rest.
  constexpr double kTolerance = 0.01;
  constexpr double kShort_s = 1e-5;
  const FeedbackLinearisationGains proportional{.force_1_s = 900.0, .integral_1_s2 = 0.0, .velocity_compensation = 1.0};
  for (const double error_N : {50.0, -50.0, 400.0, -400.0}) {
    for (const double force_N : {-600.0, 0.0, 1500.0}) {
      plant::HydraulicJoint joint = held(hyq_cylinder(), force_N / hyq_cylinder().area_a, error_N > 0.0);
      FeedbackLinearisation law = controller(proportional);
      const double before = joint.hydraulic_force();
      const auto output = law.step(before + error_N, {0.0, 0.0, before});
      ASSERT_FALSE(output.saturated);
      joint.step(output.valve_current_A, 0.0, kShort_s);
      const double rate = (joint.hydraulic_force() - before) / kShort_s;
      EXPECT_NEAR(rate, proportional.force_1_s * error_N, kTolerance * std::abs(proportional.force_1_s * error_N))
          << error_N << " N at " << force_N << " N";
    }
  }
}

TEST(FeedbackLinearisation, FeedsTheFlowThatAMovingPistonTakes) {
  // q_a = A_p v, with q_a = K_v u sqrt(p_s - p_a), and sqrt(p_s - p_a) = sqrt(drop / (1 + alpha^3)) by (3.20).
  const plant::ActuatorParams a = hyq_cylinder();
  const double alpha = a.area_b / a.area_a;
  constexpr double kVelocity = 0.1;
  FeedbackLinearisation law = controller({.force_1_s = 0.0, .integral_1_s2 = 0.0, .velocity_compensation = 1.0});
  const double drop_Pa = a.supply_pressure_Pa - a.piston_damping * kVelocity / a.area_a - alpha * a.return_pressure_Pa;
  const double root = std::sqrt(drop_Pa / (1.0 + alpha * alpha * alpha));
  const double expected_A = a.area_a * kVelocity / (a.valve_gain * root);
  EXPECT_NEAR(law.step(0.0, {0.0, kVelocity, 0.0}).valve_current_A, expected_A, 1e-12 * a.valve_current_max_A);
}

TEST(FeedbackLinearisation, TakesTheGainOfAnotherValve) {
  const plant::ActuatorParams a = hyq_cylinder();
  FeedbackLinearisation law = controller({.integral_1_s2 = 0.0});
  FeedbackLinearisation told = law;
  plant::JointPhysics weak = plant::nominal_physics(a, plant::test::swing_load());
  weak.valve_gain *= 0.5;
  ASSERT_TRUE(told.set_physics(weak));
  const Measurement rest{0.0, 0.0, 300.0};
  EXPECT_NEAR(told.step(310.0, rest).valve_current_A, 2.0 * law.step(310.0, rest).valve_current_A, 1e-15);
  weak.valve_gain = -1.0;
  EXPECT_FALSE(told.set_physics(weak)) << "no valve has that gain";
}

TEST(FeedbackLinearisation, MakesUpForWhatLeaksPastThePiston) {
  const plant::ActuatorParams a = hyq_cylinder();
  constexpr double kLeakage_m3_s_Pa = 5e-13;
  constexpr double kShort_s = 1e-5;
  plant::JointPhysics leaks = plant::nominal_physics(a, plant::test::swing_load());
  leaks.leakage = kLeakage_m3_s_Pa;
  FeedbackLinearisation law = controller({.integral_1_s2 = 0.0});
  const auto rate_of = [&](FeedbackLinearisation& of) {
    const plant::HydraulicJoint tight = held(a, 2000.0 / a.area_a, true);
    const std::array effects{plant::ActiveEffect{plant::effect_id<plant::InternalLeakage>(), {kLeakage_m3_s_Pa}}};
    plant::HydraulicJoint joint = plant::HydraulicJoint::create(a, {.mass = 1e6}, tight.state(),
                                                                plant::HydraulicJoint::kDefaultTolerance, effects)
                                      .value();
    const double before = joint.hydraulic_force();
    joint.step(of.step(before, {0.0, 0.0, before}).valve_current_A, 0.0, kShort_s);
    return (joint.hydraulic_force() - before) / kShort_s;
  };
  const double without = rate_of(law);
  ASSERT_TRUE(law.set_physics(leaks));
  EXPECT_LT(without, -1e4) << "N/s";
  EXPECT_NEAR(rate_of(law), 0.0, 0.02 * std::abs(without));
}

TEST(FeedbackLinearisation, RemovesAnErrorOfTheFlowLawByItsObserver) {
  // The plant's valve has 0.6 of the gain that the law knows: a held force lags behind a ramp.
  const auto lag_of = [](double observer_1_s) {
    plant::ActuatorParams weak = hyq_cylinder();
    weak.valve_gain *= 0.6;
    plant::HydraulicJoint joint = held(weak, 0.0, true);
    FeedbackLinearisation law = controller({.force_1_s = 300.0, .integral_1_s2 = 0.0, .observer_1_s = observer_1_s});
    double lag_N = 0.0;
    for (int tick = 0; tick < 200; ++tick) {
      const double reference_N = 5.0 * tick;
      const Measurement now = measured(joint);
      lag_N = reference_N - now.force;
      joint.step(law.step(reference_N, now).valve_current_A, 0.0, kPeriod_s);
    }
    return lag_N;
  };
  EXPECT_GT(lag_of(0.0), 20.0);
  EXPECT_LT(std::abs(lag_of(100.0)), 0.75 * lag_of(0.0));
}

TEST(FeedbackLinearisation, TracksAForceOnALightAndAHeavyLoadWithOneSetting) {
  constexpr double kReference_N = 500.0;
  constexpr double kSettled_N = 0.02 * kReference_N;  // the load slides off at F / d: a ramp the integral follows
  for (const plant::LoadParams& load : {plant::LoadParams{2.5, 2500.0}, plant::LoadParams{50.0, 2500.0}}) {
    plant::HydraulicJoint joint = plant::test::joint_at_rest(hyq_cylinder(), load);
    FeedbackLinearisation law = controller();
    for (int tick = 0; tick < 100; ++tick) {
      joint.step(law.step(kReference_N, measured(joint)).valve_current_A, 0.0, kPeriod_s);
      if (tick >= 50) {
        ASSERT_NEAR(joint.load_cell_force(), kReference_N, kSettled_N) << load.mass << " kg, tick " << tick;
      }
    }
  }
}

TEST(FeedbackLinearisation, StartsFromNullCurrentAndAgainAfterReset) {
  FeedbackLinearisation law = controller();
  const Measurement moving{0.01, 0.05, 100.0};
  EXPECT_EQ(law.step(600.0, moving).valve_current_A, 0.0);
  EXPECT_GT(law.step(900.0, moving).valve_current_A, 0.0);
  law.reset();
  EXPECT_EQ(law.integrator(), 0.0);
  EXPECT_EQ(law.step(900.0, moving).valve_current_A, 0.0);
}

TEST(FeedbackLinearisation, StaysWithinTheValveAndDoesNotWindUp) {
  const double limit_A = hyq_cylinder().valve_current_max_A;
  FeedbackLinearisation law = controller();
  law.step(0.0, {0.0, 0.0, 0.0});
  law.step(1e5, {0.0, 0.0, 0.0});
  const double before = law.integrator();
  for (int i = 0; i < 1000; ++i) {
    const auto output = law.step(1e5, {0.0, 0.0, 0.0});
    ASSERT_EQ(output.valve_current_A, limit_A);
    ASSERT_TRUE(output.saturated);
  }
  EXPECT_EQ(law.integrator(), before);
  EXPECT_LT(law.step(-1e3, {0.0, 0.0, 0.0}).valve_current_A, 0.0);
}

TEST(FeedbackLinearisation, GivesNullCurrentForATickWithoutNumbersAndForgetsIt) {
  FeedbackLinearisation law = controller();
  law.step(0.0, {0.0, 0.0, 0.0});
  law.step(100.0, {0.0, 0.0, 0.0});
  const double before = law.integrator();
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(law.step(bad, {0.0, 0.0, 0.0}).valve_current_A, 0.0);
    EXPECT_EQ(law.step(100.0, {0.0, bad, 0.0}).valve_current_A, 0.0);
    EXPECT_EQ(law.step(100.0, {0.0, 0.0, bad}).valve_current_A, 0.0);
  }
  EXPECT_EQ(law.step(100.0, {kNaN, 0.0, 0.0}).valve_current_A, 0.0);
  EXPECT_EQ(law.integrator(), before);
}

TEST(FeedbackLinearisation, StepDoesNotAllocate) {
  FeedbackLinearisation law = controller();
  const farrier::test::AllocationGuard guard;
  for (int i = 0; i < 100; ++i) {
    law.step(10.0 * i, {0.001, 0.01 * i, 5.0 * i});
  }
  law.reset();
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace feedback_linearisation_test
}  // namespace farrier::control
