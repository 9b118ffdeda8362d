#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "plant/force_dynamics.hpp"
#include "test_joints.hpp"

namespace farrier::plant {
namespace force_dynamics_test {

double jerk(const JointEquations& equations, const IntegrationState& s, const HeldInput& input) {
  // M a' = F_h' - B a - C v, from the rates of the pressures themselves.
  const ActuatorParams& act = equations.actuator();
  const LoadParams& load = equations.load();
  const IntegrationState rate = equations.derivative(s, input);
  return (act.area_a * rate.compression_a_Pa - act.area_b * rate.compression_b_Pa -
          (load.damping + act.piston_damping) * rate.velocity - load.stiffness * s.velocity) /
         (load.mass + act.piston_mass);
}

struct Case {
  ActuatorParams actuator;
  LoadParams load;
  State state;
  double current_A;
  double external_force;
};

/// Seeded points well inside the stroke, chambers between return and supply, both signs of the valve.
Case random_case(int i) {
  const NoiseStream draw(11, "forces", "points");
  const auto uniform = [&](int channel, double low, double high) {
    return low + (high - low) * draw.uniform(16 * i + channel);
  };
  Case one;
  one.actuator = i % 3 == 0 ? test::hyq_rotary_motor() : i % 3 == 1 ? test::hyq_cylinder() : test::rig_cylinder();
  one.load = {uniform(0, 1.0, 60.0), uniform(1, 0.0, 1000.0), uniform(2, 0.0, 3e4), 0.5 * one.actuator.stroke};
  if (i % 3 == 0) {
    one.load = {uniform(0, 0.05, 5.0), uniform(1, 0.0, 10.0), uniform(2, 0.0, 300.0), 0.5 * one.actuator.stroke};
  }
  const double p_s = one.actuator.supply_pressure_Pa;
  one.state = {one.actuator.stroke * uniform(3, 0.1, 0.9), velocity_scale(one.actuator) * uniform(4, -0.1, 0.1),
               p_s * uniform(5, 0.1, 0.9), p_s * uniform(6, 0.1, 0.9)};
  one.current_A = (i % 2 == 0 ? 1.0 : -1.0) * one.actuator.valve_current_max_A * uniform(7, 0.01, 0.5);
  one.external_force = one.actuator.area_a * p_s * uniform(8, -0.2, 0.2);
  return one;
}

TEST(Forces, AgreeWithTheEquationsTheJointIsIntegratedBy) {
  constexpr double kRounding = 1e-13;  // of some twenty operations on terms of the sizes below
  for (int i = 0; i < 300; ++i) {
    const Case one = random_case(i);
    const JointEquations equations(one.actuator, one.load);
    const HeldInput input = equations.hold(one.current_A, one.external_force);
    const IntegrationState s{one.state.position, one.state.velocity, one.state.pressure_a_Pa, one.state.pressure_b_Pa};
    const IntegrationState rate = equations.derivative(s, input);
    const Forces of = forces(one.actuator, one.load, one.state, one.current_A, one.external_force);
    const double inertia = one.load.mass + one.actuator.piston_mass;
    const double force_scale = 2.0 * one.actuator.area_a * one.actuator.supply_pressure_Pa +
                               one.load.stiffness * one.actuator.stroke +
                               (one.load.damping + one.actuator.piston_damping) * std::abs(s.velocity);
    EXPECT_NEAR(of.hydraulic, equations.hydraulic_force(s), kRounding * force_scale) << i;
    EXPECT_NEAR(of.total, inertia * rate.velocity, kRounding * force_scale) << i;
    // (2.22), right side: what the cell does to the load.
    EXPECT_NEAR(of.load_cell,
                one.load.mass * rate.velocity + one.load.damping * s.velocity +
                    one.load.stiffness * (s.position - one.load.equilibrium_position) - one.external_force,
                10.0 * kRounding * force_scale) << i;
    const double rate_scale = std::abs(one.actuator.area_a * rate.compression_a_Pa) +
                              std::abs(one.actuator.area_b * rate.compression_b_Pa) +
                              (one.load.damping + one.actuator.piston_damping) * std::abs(rate.velocity) +
                              one.load.stiffness * std::abs(s.velocity) +
                              force_scale * one.load.damping / inertia;
    EXPECT_NEAR(of.hydraulic_rate, one.actuator.area_a * rate.compression_a_Pa -
                                       one.actuator.area_b * rate.compression_b_Pa, 10.0 * kRounding * rate_scale) << i;
    EXPECT_NEAR(of.total_rate, inertia * jerk(equations, s, input), 10.0 * kRounding * rate_scale) << i;
    // (2.22), right side, once more in time.
    EXPECT_NEAR(of.load_cell_rate, one.load.mass * jerk(equations, s, input) + one.load.damping * rate.velocity +
                                       one.load.stiffness * s.velocity, 10.0 * kRounding * rate_scale) << i;
  }
}

TEST(Forces, ChangeAsTheSimulatedJointsDo) {
  constexpr double kStep_s = 1e-5;
  // Five-point differences of step h err by (w h)^4 / 30 for the fastest motion w. The joint's own is below 5e3 rad/s
  // and an orifice's laminar range below 2e4 rad/s: 5e-5. Rounding and integration at 1e-12 of the state: 1e-6.
  constexpr double kTolerance = 1e-4;
  int checked = 0;
  for (int i = 0; i < 60; ++i) {
    const Case one = random_case(i);
    HydraulicJoint joint = HydraulicJoint::create(one.actuator, one.load, one.state, 1e-12).value();
    // A tick in, the valve's step and the start from off the steady pressures are past.
    joint.step(one.current_A, one.external_force, test::kPeriod_s);
    std::array<Forces, 5> measured{};
    Forces of{};
    bool undisturbed = true;
    for (int k = 0; k < 5; ++k) {
      const StepReport report = joint.step(one.current_A, one.external_force, kStep_s);
      undisturbed = undisturbed && !report.at_stop && !report.cavitated;
      measured[k].hydraulic = joint.hydraulic_force();
      measured[k].total = (one.load.mass + one.actuator.piston_mass) * joint.acceleration();
      measured[k].load_cell = joint.load_cell_force();
      if (k == 2) {
        of = forces(one.actuator, one.load, joint.state(), one.current_A, one.external_force);
      }
    }
    if (!undisturbed) {
      continue;
    }
    ++checked;
    const auto slope = [&](double Forces::*force) {
      return (measured[0].*force - 8.0 * measured[1].*force + 8.0 * measured[3].*force - measured[4].*force) /
             (12.0 * kStep_s);
    };
    const TransmissionStiffness drive = transmission_stiffness(one.actuator, joint.state(), one.current_A);
    const double scale = drive.K_th * (std::abs(drive.q_e) + drive.A_e * std::abs(joint.state().velocity)) +
                         (one.load.damping + one.actuator.piston_damping) * std::abs(joint.acceleration()) +
                         1e-3 * one.actuator.area_a * one.actuator.supply_pressure_Pa / test::kPeriod_s;
    EXPECT_NEAR(slope(&Forces::hydraulic), of.hydraulic_rate, kTolerance * scale) << i;
    EXPECT_NEAR(slope(&Forces::total), of.total_rate, kTolerance * scale) << i;
    EXPECT_NEAR(slope(&Forces::load_cell), of.load_cell_rate, kTolerance * scale) << i;
  }
  EXPECT_GE(checked, 50);
}

TEST(Forces, AreNotTheSameForceAndMeetWhereNothingMoves) {
  const ActuatorParams act = test::hyq_cylinder();
  const LoadParams load{20.0, 300.0, 1e4, 0.04};
  // Held at rest by a force from outside: hydraulic and load-cell force are equal, the total one is zero.
  const State rest = equilibrium(act, load, 0.05, 200.0);
  const Forces still = forces(act, load, rest, 0.0, 200.0);
  EXPECT_NEAR(still.total, 0.0, 1e-9);
  EXPECT_NEAR(still.load_cell, still.hydraulic, 1e-9);
  EXPECT_NEAR(still.hydraulic, 1e4 * 0.01 - 200.0, 1e-9);
  State moving = rest;
  moving.velocity = 0.1;
  const Forces moved = forces(act, load, moving, 0.0, 200.0);
  EXPECT_NEAR(moved.hydraulic - moved.load_cell, act.piston_damping * 0.1 + act.piston_mass * moved.total / 20.3141,
              1e-9);
}

TEST(Forces, TransmissionStiffnessOfAShutValveIsThatOfBothChambersOfOil) {
  // A symmetric motor in the middle: each chamber is a spring A^2 beta / V, and the equivalent area is its own.
  const ActuatorParams motor = test::hyq_rotary_motor();
  const State middle{0.5 * motor.stroke, 0.3, 80e5, 80e5};
  const TransmissionStiffness drive = transmission_stiffness(motor, middle, 0.0);
  const double volume = motor.line_volume_m3 + 0.5 * motor.area_a * motor.stroke;
  EXPECT_NEAR(drive.K_th * drive.A_e, 2.0 * motor.area_a * motor.area_a * motor.bulk_modulus_Pa / volume,
              1e-12 * drive.K_th * drive.A_e);
  EXPECT_DOUBLE_EQ(drive.A_e, motor.area_a);
  EXPECT_EQ(drive.q_e, 0.0);
}

TEST(Forces, OfANonFiniteStateAreNotFinite) {
  State state = equilibrium(test::hyq_cylinder(), test::stance_load(), 0.04, 0.0);
  state.pressure_a_Pa = NAN;
  const Forces of = forces(test::hyq_cylinder(), test::stance_load(), state, 1e-3, 0.0);
  EXPECT_TRUE(std::isnan(of.hydraulic) && std::isnan(of.total) && std::isnan(of.load_cell));
  EXPECT_TRUE(std::isnan(of.hydraulic_rate) && std::isnan(of.total_rate) && std::isnan(of.load_cell_rate));
}

}  // namespace force_dynamics_test
}  // namespace farrier::plant
