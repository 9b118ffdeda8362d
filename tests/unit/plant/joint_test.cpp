#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test_joints.hpp"

namespace farrier::plant {
namespace joint_test {

using test::kPeriod_s;

/// Oil in a chamber as the volume it would fill without pressure: V exp(p / beta_e), the integral of (2.9).
double oil_m3(double volume_m3, double pressure_Pa, const ActuatorParams& act) {
  return volume_m3 * std::exp(pressure_Pa / act.bulk_modulus_Pa);
}
double volume_a(const HydraulicJoint& joint) {
  return joint.actuator().line_volume_m3 + joint.actuator().area_a * joint.state().position;
}
double volume_b(const HydraulicJoint& joint) {
  const ActuatorParams& act = joint.actuator();
  return act.line_volume_m3 + act.area_b * (act.stroke - joint.state().position);
}

TEST(Cylinder, ConservesFluidVolumeWhenValveIsShut) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  const ActuatorParams& act = joint.actuator();
  const double before_a = oil_m3(volume_a(joint), joint.state().pressure_a_Pa, act);
  const double before_b = oil_m3(volume_b(joint), joint.state().pressure_b_Pa, act);
  double summed_error_Pa = 0.0;
  double moved = 0.0;
  for (int tick = 0; tick < 500; ++tick) {
    const StepReport report = joint.step(0.0, (tick / 50) % 2 == 0 ? 400.0 : -300.0, kPeriod_s);
    ASSERT_FALSE(report.cavitated);
    summed_error_Pa += report.error_pressure_Pa;
    moved = std::max(moved, std::abs(joint.state().velocity));
    // A pressure error of e leaves V e / beta_e of oil unaccounted for.
    const double tolerance_a = volume_a(joint) * summed_error_Pa / act.bulk_modulus_Pa + 1e-12 * before_a;
    const double tolerance_b = volume_b(joint) * summed_error_Pa / act.bulk_modulus_Pa + 1e-12 * before_b;
    ASSERT_NEAR(oil_m3(volume_a(joint), joint.state().pressure_a_Pa, act), before_a, tolerance_a);
    ASSERT_NEAR(oil_m3(volume_b(joint), joint.state().pressure_b_Pa, act), before_b, tolerance_b);
  }
  EXPECT_GT(moved, 0.005);
}

TEST(Cylinder, RefillsAVoidBeforePressureRises) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  const ActuatorParams& act = joint.actuator();
  const double oil = oil_m3(volume_a(joint), joint.state().pressure_a_Pa, act);
  bool cavitated = false;
  double summed_error_Pa = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    const StepReport report = joint.step(0.0, tick < 200 ? 9000.0 : -500.0, kPeriod_s);
    summed_error_Pa += report.error_pressure_Pa;
    cavitated |= report.cavitated;
    // Oil plus void always fills the chamber.
    const double filled = volume_a(joint) - joint.void_volume_a_m3();
    const double tolerance_m3 = volume_a(joint) * summed_error_Pa / act.bulk_modulus_Pa + 1e-6 * oil;
    ASSERT_NEAR(oil_m3(filled, joint.state().pressure_a_Pa, act), oil, tolerance_m3) << "tick " << tick;
    ASSERT_TRUE(joint.void_volume_a_m3() == 0.0 || joint.state().pressure_a_Pa == 0.0);
  }
  EXPECT_TRUE(cavitated);
  EXPECT_EQ(joint.void_volume_a_m3(), 0.0);
}

/// Kinetic, spring and oil energy with the valve shut. A chamber that holds m of oil gives up dE = -p dV with
/// p = beta_e ln(m / V), hence E = beta_e (m - V) - p V, zero where p is.
double stored_energy_J(const HydraulicJoint& joint) {
  const ActuatorParams& act = joint.actuator();
  const State& s = joint.state();
  const double off = s.position - joint.load().equilibrium_position;
  const auto oil_energy = [&](double volume, double p) {
    return act.bulk_modulus_Pa * volume * std::expm1(p / act.bulk_modulus_Pa) - p * volume;
  };
  return 0.5 * (joint.load().mass + act.piston_mass) * s.velocity * s.velocity +
         0.5 * joint.load().stiffness * off * off + oil_energy(volume_a(joint), s.pressure_a_Pa) +
         oil_energy(volume_b(joint), s.pressure_b_Pa);
}

TEST(Cylinder, PassiveJointOnlyLosesEnergy) {
  const LoadParams sprung{2.5, 100.0, 21480.0, 0.04};
  State start = equilibrium(test::hyq_cylinder(), sprung, 0.04, 0.0);
  start.velocity = 0.4;
  HydraulicJoint joint = HydraulicJoint::create(test::hyq_cylinder(), sprung, start).value();
  const double first_J = stored_energy_J(joint);
  double previous_J = first_J;
  for (int tick = 0; tick < 200; ++tick) {
    const StepReport report = joint.step(0.0, 0.0, kPeriod_s);
    ASSERT_FALSE(report.cavitated);
    // dE = M v dv + F_spring dx + V p / beta_e dp per chamber, at the errors the step stated
    const State& s = joint.state();
    const ActuatorParams& act = joint.actuator();
    const double tolerance_J = 2.8141 * (std::abs(s.velocity) + 0.4) * report.error_velocity +
                               (volume_a(joint) + volume_b(joint)) * act.supply_pressure_Pa / act.bulk_modulus_Pa *
                                   report.error_pressure_Pa + 21480.0 * 0.04 * report.error_position + 1e-12 * first_J;
    const double now_J = stored_energy_J(joint);
    ASSERT_LE(now_J, previous_J + tolerance_J) << "tick " << tick;
    previous_J = now_J;
  }
  const double kinetic_J = 0.5 * 2.8141 * 0.4 * 0.4;
  EXPECT_LT(previous_J, first_J - 0.9 * kinetic_J);
}

TEST(Valve, FlowIsOddInThePressureDrop) {
  for (const double drop : {1.0, 1e3, 1e5, 1e7, 3e7}) {
    EXPECT_EQ(orifice_root(-drop, 1e5), -orifice_root(drop, 1e5));
  }
  EXPECT_EQ(orifice_root(0.0, 1e5), 0.0);
  // (1 + (delta / drop)^2)^(-1/4) = 1 - delta^2 / (4 drop^2) + ...
  EXPECT_NEAR(orifice_root(1e7, 1e5) / std::sqrt(1e7), 1.0 - 0.25e-4, 1e-8);
}

TEST(Valve, FlowReversesBeyondSupplyPressure) {
  const JointEquations equations(test::hyq_cylinder(), test::stance_load());
  const HeldInput open = equations.hold(0.01, 0.0);
  const double p_s = test::hyq_cylinder().supply_pressure_Pa;
  EXPECT_GT(equations.derivative({0.04, 0.0, p_s - 2e5, 50e5}, open).compression_a_Pa, 0.0);
  EXPECT_EQ(equations.derivative({0.04, 0.0, p_s, 50e5}, open).compression_a_Pa, 0.0);
  EXPECT_LT(equations.derivative({0.04, 0.0, p_s + 2e5, 50e5}, open).compression_a_Pa, 0.0);
}

TEST(RotaryMotor, IsTheSymmetricCylinderInOtherUnits) {
  // A cylinder of lever r is a motor of displacement r A: x = r q, F = tau / r, M = J / r^2.
  const double r = 0.25;  // a power of two, so that both round alike
  ActuatorParams cylinder = test::hyq_rotary_motor();
  cylinder.area_a = cylinder.area_b = 6.87e-6 / r;
  cylinder.stroke *= r;
  cylinder.piston_mass /= r * r;
  cylinder.piston_damping /= r * r;
  cylinder.stop_stiffness /= r * r;
  cylinder.stop_damping /= r * r;
  HydraulicJoint motor = test::joint_at_rest(test::hyq_rotary_motor(), {0.3, 0.1, 20.0, 0.8});
  HydraulicJoint twin = test::joint_at_rest(cylinder, {0.3 / (r * r), 0.1 / (r * r), 20.0 / (r * r), 0.8 * r});
  test::ValveNoise noise(0.5, 0.1);
  for (int tick = 0; tick < 300; ++tick) {
    const double current = noise.next(motor.actuator(), motor.state().position);
    motor.step(current, 3.0, kPeriod_s);
    twin.step(current, 3.0 / r, kPeriod_s);
  }
  EXPECT_DOUBLE_EQ(twin.state().position, r * motor.state().position);
  EXPECT_DOUBLE_EQ(twin.state().velocity, r * motor.state().velocity);
  EXPECT_DOUBLE_EQ(twin.state().pressure_a_Pa, motor.state().pressure_a_Pa);
  EXPECT_DOUBLE_EQ(twin.load_cell_force(), motor.load_cell_force() / r);
}

TEST(HydraulicJoint, KeepsItsMotionWhenTheMassJumps) {
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), test::swing_load());
  for (int tick = 0; tick < 20; ++tick) {
    joint.step(0.003, 0.0, kPeriod_s);
  }
  const State before = joint.state();
  const double acceleration = joint.acceleration();
  ASSERT_TRUE(joint.set_load({50.0, 100.0, 0.0, 0.0}));
  EXPECT_EQ(joint.state().position, before.position);
  EXPECT_EQ(joint.state().velocity, before.velocity);
  EXPECT_EQ(joint.state().pressure_a_Pa, before.pressure_a_Pa);
  EXPECT_NEAR(joint.acceleration() * 50.3141, acceleration * 2.8141, 1e-9 * std::abs(acceleration * 2.8141));
}

TEST(HydraulicJoint, RestsInItsEquilibriumUnderTheForceItHolds) {
  const LoadParams sprung{50.0, 500.0, 21480.0, 0.04};
  for (const double force : {-1500.0, 0.0, 900.0, 2500.0}) {
    const State rest = equilibrium(test::hyq_cylinder(), sprung, 0.05, force);
    HydraulicJoint joint = HydraulicJoint::create(test::hyq_cylinder(), sprung, rest).value();
    joint.step(0.0, force, kPeriod_s);
    EXPECT_NEAR(joint.state().velocity, 0.0, 1e-12);
    EXPECT_NEAR(joint.hydraulic_force(), 21480.0 * 0.01 - force, 1e-9 * 3000.0);
    EXPECT_GE(std::min(rest.pressure_a_Pa, rest.pressure_b_Pa), test::hyq_cylinder().return_pressure_Pa);
  }
}

TEST(LoadCell, ReadsTheSameFromBothSides) {
  // (2.22): F_h - d_p v - m_p a = C (x - x_eq) + d_l v + m_l a - F_ext
  const LoadParams sprung{10.0, 700.0, 21480.0, 0.04};
  HydraulicJoint joint = test::joint_at_rest(test::hyq_cylinder(), sprung);
  test::ValveNoise noise(0.5, 0.1);
  for (int tick = 0; tick < 300; ++tick) {
    joint.step(noise.next(joint.actuator(), joint.state().position), 120.0, kPeriod_s);
    const State& s = joint.state();
    const double right = 21480.0 * (s.position - 0.04) + 700.0 * s.velocity + 10.0 * joint.acceleration() - 120.0;
    ASSERT_NEAR(joint.load_cell_force(), right, 1e-10 * 5000.0);
  }
}

}  // namespace joint_test
}  // namespace farrier::plant
