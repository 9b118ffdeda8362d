// Each effect against what follows from its equation by hand: another command, another parameter, or a state of rest.

#include <gtest/gtest.h>

#include <cmath>

#include "test_effects.hpp"

namespace farrier::plant {
namespace terms_steady_test {

using test::effect_of;
using test::joint_with;
using test::kPeriod_s;
using test::same;

const ActuatorParams kCylinder = test::hyq_cylinder();
const LoadParams kLoad = test::swing_load();
/// Symmetric, so that steady flows and forces have one size.
const ActuatorParams kMotor = test::hyq_rotary_motor();
const LoadParams kFoot{0.3, 5.0, 0.0, 0.0};

/// Stiffness of the shut motor's oil in mid-stroke with 1/beta + softness for 1/beta, Nm/rad.
double oil_stiffness(double softness = 0.0) {
  const double volume = kMotor.line_volume_m3 + 0.5 * kMotor.area_a * kMotor.stroke;
  return 2.0 * kMotor.area_a * kMotor.area_a / (volume * (1.0 / kMotor.bulk_modulus_Pa + softness));
}

void settle(HydraulicJoint& joint, double current_A, double force, int ticks = 3000) {
  for (int tick = 0; tick < ticks; ++tick) {
    joint.step(current_A, force, kPeriod_s);
  }
}

/// Expects a joint with the effect to be the nominal one under another command, bit for bit.
template <class Command>
void expect_same_as_command(const ActiveEffect& effect, Command command) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {effect});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  for (int tick = 0; tick < 200; ++tick) {
    const double current = 0.004 * std::sin(0.1 * tick);
    with.step(current, 0.0, kPeriod_s);
    nominal.step(command(current), 0.0, kPeriod_s);
    ASSERT_TRUE(same(with, nominal)) << effect.info().name << " at tick " << tick;
  }
}

TEST(ValveEffects, AreOtherCommandsToTheNominalValve) {
  // Sizes whose product with and quotient by the scale are exact.
  const double umax = kCylinder.valve_current_max_A;
  expect_same_as_command(effect_of("valve_bias", {umax * 0.0625}, kCylinder, kLoad),
                         [=](double u) { return u + umax * 0.0625; });
  expect_same_as_command(effect_of("flow_saturation", {umax * 0.5}, kCylinder, kLoad), [=](double u) {
    const double share = u * (2.0 / umax);
    return u / std::sqrt(1.0 + share * share);
  });
}

TEST(ValveEffects, ThatTheParametersKnowAreTheirs) {
  ActuatorParams overlapped = kCylinder;
  overlapped.valve_deadband_A = kCylinder.valve_current_max_A * 0x1p-5;
  ActuatorParams slow = kCylinder;
  slow.spool = {true, 900.0, 0.8};
  LoadParams sticky = kLoad;
  sticky.friction = {40.0, 52.0, 0.01, kPreslidingShare * kCylinder.stroke};
  HydraulicJoint with[] = {
      joint_with(kCylinder, kLoad, {effect_of("valve_deadband", {overlapped.valve_deadband_A}, kCylinder, kLoad)}),
      joint_with(kCylinder, kLoad, {effect_of("valve_dynamics", {900.0, 0.8}, kCylinder, kLoad)}),
      joint_with(kCylinder, kLoad, {effect_of("load_friction", {40.0, 1.3, 0.01}, kCylinder, kLoad)})};
  HydraulicJoint by_parameters[] = {joint_with(overlapped, kLoad, {}), joint_with(slow, kLoad, {}),
                                    joint_with(kCylinder, sticky, {})};
  for (int tick = 0; tick < 200; ++tick) {
    for (int i = 0; i < 3; ++i) {
      with[i].step(0.004 * std::sin(0.1 * tick), 20.0, kPeriod_s);
      by_parameters[i].step(0.004 * std::sin(0.1 * tick), 20.0, kPeriod_s);
      ASSERT_TRUE(same(with[i], by_parameters[i])) << i << " at tick " << tick;
    }
  }
}

TEST(ValveBias, ShiftsTheCommandBeforeAnOverlapThatTheParametersHave) {
  ActuatorParams overlapped = kCylinder;
  overlapped.valve_deadband_A = 1e-4;
  HydraulicJoint joint = joint_with(overlapped, kLoad, {effect_of("valve_bias", {3e-4}, kCylinder, kLoad)});
  joint.step(-2e-4, 0.0, kPeriod_s);
  EXPECT_NEAR(joint.effects().opening_A, 0.0, 1e-12);  // |-2e-4 + 3e-4| within the overlap
  joint.step(2e-4, 0.0, kPeriod_s);
  EXPECT_NEAR(joint.effects().opening_A, 4e-4, 1e-12);
}

TEST(ValveAsymmetry, ScalesTheGainByDirection) {
  for (const double sign : {1.0, -1.0}) {
    ActuatorParams scaled = kCylinder;
    scaled.valve_gain *= 1.0 + 0.25 * sign;
    HydraulicJoint with = joint_with(kCylinder, kLoad, {effect_of("valve_asymmetry", {0.25}, kCylinder, kLoad)});
    HydraulicJoint other = joint_with(scaled, kLoad, {});
    settle(with, sign * 1e-3, 0.0, 100);
    settle(other, sign * 1e-3, 0.0, 100);
    EXPECT_NEAR(with.state().velocity, other.state().velocity, 1e-5 * std::abs(other.state().velocity));
  }
}

TEST(InputDelay, IsTheSameMotionLater) {
  HydraulicJoint late = joint_with(kCylinder, kLoad, {effect_of("input_delay", {2e-3}, kCylinder, kLoad)});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  const auto current = [](int tick) { return tick < 0 ? 0.0 : 0.003 * std::sin(0.2 * tick + 1.0); };
  for (int tick = 0; tick < 3000; ++tick) {
    late.step(current(tick), 0.0, kPeriod_s);
    nominal.step(current(tick - 2), 0.0, kPeriod_s);
    ASSERT_TRUE(same(late, nominal)) << tick;
  }
}

// 0.3 and 0.7 of every tick; what is left of their differences must not add up.
TEST(InputDelay, NeedBeNoWholeNumberOfTicks) {
  HydraulicJoint late = joint_with(kCylinder, kLoad, {effect_of("input_delay", {1.3e-3}, kCylinder, kLoad)});
  HydraulicJoint parts = joint_with(kCylinder, kLoad, {});
  const auto current = [](int tick) { return tick < 0 ? 0.0 : 0.003 * std::sin(0.2 * tick + 1.0); };
  for (int tick = 0; tick < 3000; ++tick) {
    late.step(current(tick), 0.0, kPeriod_s);
    parts.step(current(tick - 2), 0.0, 0.3e-3);
    parts.step(current(tick - 1), 0.0, 0.7e-3);
    ASSERT_NEAR(late.state().position, parts.state().position, 1e-6 * kCylinder.stroke) << tick;
  }
}

// Two symmetric chambers, valve shut: A v = c (p_b - p_a), A (p_a - p_b) + F = D v.
TEST(InternalLeakage, LetsAHeldLoadCreep) {
  constexpr double kLeak = 2e-14;
  constexpr double kTorque = 20.0;
  HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("internal_leakage", {kLeak}, kMotor, kFoot)});
  settle(joint, 0.0, kTorque, 2000);  // ten times V / (2 beta c)
  const double damping = kFoot.damping + kMotor.piston_damping;
  const double expected = kLeak * kTorque / (kMotor.area_a * kMotor.area_a + kLeak * damping);
  EXPECT_NEAR(joint.state().velocity, expected, 0.01 * expected);
}

TEST(AirEntrainment, SoftensTheOilByItsPressure) {
  constexpr double kAir = 0.03;
  constexpr double kTorque = 2.0;  // small: pressures stay near those at rest
  HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("air_entrainment", {kAir}, kMotor, kFoot)});
  const double pressure = joint.state().pressure_a_Pa;
  settle(joint, 0.0, kTorque);
  const double softness = kAir / (1.4 * 1e5) * std::pow(1e5 / pressure, 1.0 + 1.0 / 1.4);
  const double bent = kTorque / oil_stiffness(softness);
  EXPECT_NEAR(joint.state().position - 0.5 * kMotor.stroke, bent, 0.01 * bent);
  EXPECT_GT(bent, 1.05 * kTorque / oil_stiffness());
}

// q = K_v u sqrt(p_s - R q - p_a), q = A v in steady motion.
TEST(SupplyDroop, TakesThePressureThatTheFlowCosts) {
  constexpr double kCurrent = 0.004;
  const double resistance = 0.5 * Scales(kMotor, kFoot).of(Scale::kDroop);
  State start = equilibrium(kMotor, kFoot, 0.1, 0.0);
  const std::array effects{effect_of("supply_droop", {resistance}, kMotor, kFoot)};
  HydraulicJoint joint = HydraulicJoint::create(kMotor, kFoot, start, 1e-8, effects).value();
  settle(joint, kCurrent, 0.0, 100);
  const double flow = kMotor.area_a * joint.state().velocity;
  const double drop = kMotor.supply_pressure_Pa - resistance * flow - joint.state().pressure_a_Pa;
  EXPECT_GT(resistance * flow, 1e5);
  EXPECT_NEAR(kMotor.valve_gain * kCurrent * std::sqrt(drop), flow, 0.005 * flow);
}

// With an accumulator the supply falls as 1 - exp(-t / tau) to what the flow costs at last.
TEST(SupplyDroop, FollowsTheFlowWithItsTimeConstant) {
  constexpr double kCurrent = 0.004;
  constexpr double kTimeConstant_s = 0.01;
  const double resistance = 0.5 * Scales(kMotor, kFoot).of(Scale::kDroop);
  const State start = equilibrium(kMotor, kFoot, 0.1, 0.0);
  const auto flow_after = [&](double time_constant_s, int ticks) {
    const std::array effects{effect_of("supply_droop", {resistance, time_constant_s}, kMotor, kFoot)};
    HydraulicJoint joint = HydraulicJoint::create(kMotor, kFoot, start, 1e-8, effects).value();
    settle(joint, kCurrent, 0.0, ticks);
    return kMotor.area_a * joint.state().velocity;
  };
  EXPECT_NEAR(flow_after(kTimeConstant_s, 100), flow_after(0.0, 100), 0.002 * flow_after(0.0, 100));
  const double without = flow_after(1.0, 10);  // the fall has not begun
  const double at_last = flow_after(0.0, 10);
  EXPECT_GT(without, 1.02 * at_last);
  EXPECT_GT(flow_after(kTimeConstant_s, 10), at_last);
  EXPECT_LT(flow_after(kTimeConstant_s, 10), without);
}

// Past shut lands each chamber fills until what comes from the supply goes to the return: half of both pressures.
TEST(ValveDeadband, LeaksPastItsLands) {
  const double leakage = 0.01 * Scales(kMotor, kFoot).of(Scale::kLeakage);
  State start = equilibrium(kMotor, kFoot, 0.1, 0.0);
  start.pressure_a_Pa = start.pressure_b_Pa = 0.2 * kMotor.supply_pressure_Pa;
  const std::array effects{effect_of("valve_deadband", {1e-4, leakage}, kMotor, kFoot)};
  HydraulicJoint joint = HydraulicJoint::create(kMotor, kFoot, start, 1e-8, effects).value();
  settle(joint, 0.5e-4, 0.0, 2000);
  const double middle = 0.5 * (kMotor.supply_pressure_Pa + kMotor.return_pressure_Pa);
  EXPECT_NEAR(joint.state().pressure_a_Pa, middle, 0.01 * middle);
  EXPECT_NEAR(joint.state().pressure_b_Pa, middle, 0.01 * middle);
}

// At rest the force across the play is the load's: the load has moved by oil and play.
TEST(Backlash, GivesWayByHalfOfItselfOnTopOfTheOil) {
  constexpr double kPlay = 0.004;
  constexpr double kTorque = 3.0;
  HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("backlash", {kPlay}, kMotor, kFoot)});
  settle(joint, 0.0, kTorque);
  const double force_0 = kMotor.supply_pressure_Pa * kMotor.area_a / 200.0;
  const double expected = kTorque / oil_stiffness() + 0.5 * kPlay * std::tanh(kTorque / force_0);
  EXPECT_NEAR(joint.state().position - 0.5 * kMotor.stroke, expected, 0.01 * expected);
  EXPECT_NEAR(joint.load_cell_force(), -kTorque, 1e-3 * kTorque);
}

TEST(Backlash, GivesWayByItsFlanksToo) {
  constexpr double kPlay = 0.004;
  constexpr double kTorque = 3.0;
  const double flanks = 600.0 * Scales(kMotor, kFoot).of(Scale::kStiffness);
  const auto at_rest = [&](std::initializer_list<double> values) {
    HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("backlash", values, kMotor, kFoot)});
    settle(joint, 0.0, kTorque);
    return joint.state().position;
  };
  const double further = kTorque / flanks;
  EXPECT_NEAR(at_rest({kPlay, flanks}) - at_rest({kPlay}), further, 0.02 * further);
}

TEST(EndStop, HoldsThePistonAndTheLoadCellFeelsNothing) {
  constexpr double kInset = 0.3;
  HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("end_stop", {kInset, 5e4}, kMotor, kFoot)});
  settle(joint, 1e-3, 0.0, 5000);
  const double push = joint.hydraulic_force();
  EXPECT_GT(push, 0.9 * kMotor.area_a * (kMotor.supply_pressure_Pa - kMotor.return_pressure_Pa));
  EXPECT_NEAR(joint.state().position, kMotor.stroke - kInset + push / 5e4, 1e-5);
  EXPECT_NEAR(joint.load_cell_force(), 0.0, 1e-3 * push);
}

// Held by its seals the piston keeps the force from the oil, and the load cell reads it; held by its guide the load
// keeps it from both.
TEST(Frictions, HoldOnTheirSideOfTheLoadCell) {
  constexpr double kTorque = 2.0;
  HydraulicJoint seals = joint_with(
      kMotor, kFoot,
      {effect_of("piston_friction", {5.0}, kMotor, kFoot), effect_of("internal_leakage", {5e-13}, kMotor, kFoot)});
  HydraulicJoint guide = joint_with(
      kMotor, kFoot,
      {effect_of("load_friction", {5.0}, kMotor, kFoot), effect_of("internal_leakage", {5e-13}, kMotor, kFoot)});
  settle(seals, 0.0, kTorque, 6000);
  settle(guide, 0.0, kTorque, 6000);
  EXPECT_NEAR(seals.hydraulic_force(), 0.0, 0.05);  // the leak takes what is left of it
  EXPECT_NEAR(seals.load_cell_force(), -kTorque, 0.05);
  EXPECT_NEAR(seals.effects().piston_force, -kTorque, 0.05);
  EXPECT_NEAR(guide.load_cell_force(), 0.0, 0.05);
  EXPECT_NEAR(guide.effects().friction, kTorque, 0.05);
}

TEST(Frictions, OfALoadStayWhenTheLoadChanges) {
  HydraulicJoint joint = joint_with(kCylinder, kLoad, {effect_of("load_friction", {60.0}, kCylinder, kLoad)});
  ASSERT_TRUE(joint.set_load(test::stance_load()));
  EXPECT_EQ(joint.load().friction.coulomb, 60.0);
  EXPECT_EQ(joint.load().mass, test::stance_load().mass);
}

TEST(ExternalForce, IsOneThatIsAlwaysThere) {
  HydraulicJoint with = joint_with(kMotor, kFoot, {effect_of("external_force", {7.0}, kMotor, kFoot)});
  HydraulicJoint nominal = joint_with(kMotor, kFoot, {});
  settle(with, 1e-4, 1.0, 100);
  settle(nominal, 1e-4, 8.0, 100);
  EXPECT_NEAR(with.state().velocity, nominal.state().velocity, 1e-9);
  EXPECT_NEAR(with.load_cell_force(), nominal.load_cell_force(), 1e-6);
}

TEST(SpringHardening, PullsWithTheCubeOfTheWay) {
  constexpr double kCubic = 500.0;
  HydraulicJoint joint = joint_with(kMotor, kFoot, {effect_of("spring_hardening", {kCubic, 0.4}, kMotor, kFoot)});
  settle(joint, 0.0, 0.0);
  const double way = joint.state().position - 0.4;
  EXPECT_NEAR(joint.load_cell_force(), kCubic * way * way * way, 1e-3);
}

TEST(LoadEffects, ChangeTheStanceLoadByTheSameDifference) {
  const Loads nominal{{2.5, 500.0, 1000.0, 0.03}, {50.0, 600.0, 3000.0, 0.05}};
  const std::array effects{effect_of("load_mass", {4.0}, kCylinder, nominal.swing),
                           effect_of("load_damping", {200.0}, kCylinder, nominal.swing),
                           effect_of("load_stiffness", {1500.0, 0.02}, kCylinder, nominal.swing)};
  const Loads loads = loads_with_effects(nominal, kCylinder, effects);
  EXPECT_DOUBLE_EQ(loads.swing.mass, 4.0);
  EXPECT_DOUBLE_EQ(loads.stance.mass, 51.5);
  EXPECT_DOUBLE_EQ(loads.swing.damping, 200.0);
  EXPECT_DOUBLE_EQ(loads.stance.damping, 300.0);
  for (const double x : {0.0, 0.08}) {  // the spring's force differs by as much in both
    const auto spring = [x](const LoadParams& load) { return load.stiffness * (x - load.equilibrium_position); };
    EXPECT_NEAR(spring(loads.stance) - spring(nominal.stance), spring(loads.swing) - spring(nominal.swing), 1e-9);
  }
  const Loads alike = loads_with_effects({nominal.swing, nominal.swing}, kCylinder, effects);
  EXPECT_EQ(alike.swing.mass, alike.stance.mass);
  EXPECT_EQ(alike.swing.equilibrium_position, alike.stance.equilibrium_position);
}

}  // namespace terms_steady_test
}  // namespace farrier::plant
