// The electric joint: equations, integration, linear models.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/noise.hpp"
#include "plant/electric_joint.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/unit/plant/reference.hpp"
#include "tests/unit/plant/test_drive.hpp"

namespace farrier::plant {
namespace electric_test {

constexpr double kPeriod_s = 1e-3;
constexpr double kRounding = 1e-12;

using test::drive;

ElectricParams without_dry_friction() {
  ElectricParams params = drive();
  params.coulomb = 0.0;
  return params;
}

LoadParams leg() { return {.mass = 0.12, .damping = 2.0}; }
LoadParams body() { return {.mass = 1.2, .damping = 2.0}; }

ElectricJoint joint_at(const ElectricParams& actuator, const LoadParams& load, ElectricState initial,
                       double tolerance = ElectricJoint::kDefaultTolerance) {
  auto joint = ElectricJoint::create(actuator, load, initial, tolerance);
  FARRIER_ENSURE(joint.ok(), joint ? "" : joint.error().message.c_str());
  return std::move(joint).value();
}

double output_constant(const ElectricParams& a) { return a.gear_ratio * a.torque_constant_Nm_A; }
double output_inertia(const ElectricParams& a) { return a.rotor_inertia_kg_m2 * a.gear_ratio * a.gear_ratio; }

/// The energy of load, rotor, springs and winding. With the command at 0 nothing adds to it:
///   E' = -d_l v^2 - d_r w^2 - T_c phi(w) w - b (w - v)^2 - R i^2.
double stored_energy_J(const ElectricJoint& joint) {
  const ElectricParams& a = joint.actuator();
  const ElectricState& s = joint.state();
  const double off = s.position - joint.load().equilibrium_position;
  return 0.5 * joint.load().mass * s.velocity * s.velocity + 0.5 * output_inertia(a) * s.rotor * s.rotor +
         0.5 * a.spring_stiffness * s.deflection * s.deflection + 0.5 * joint.load().stiffness * off * off +
         0.5 * a.winding_inductance_H * s.current_A * s.current_A;
}

TEST(ElectricJoint, OnlyLosesEnergyWithoutVoltage) {
  const LoadParams sprung{.mass = 0.3, .damping = 0.5, .stiffness = 200.0, .equilibrium_position = 1.0};
  ElectricJoint joint = joint_at(
      drive(), sprung, {.position = 1.3, .velocity = 2.0, .deflection = 2e-3, .rotor = -1.0, .current_A = 20.0});
  const double first_J = stored_energy_J(joint);
  double previous_J = first_J;
  for (int tick = 0; tick < 1000; ++tick) {
    const StepReport report = joint.step(0.0, 0.0, kPeriod_s);
    ASSERT_FALSE(report.at_stop);
    const double now_J = stored_energy_J(joint);
    // An error of the velocity's size in every state changes E by less than this.
    const double tolerance_J = report.error_velocity * (0.3 + 1.0 + 1e4 * 2e-3) * 4.0 + kRounding * first_J;
    ASSERT_LE(now_J, previous_J + tolerance_J) << "tick " << tick;
    previous_J = now_J;
  }
  EXPECT_LT(previous_J, 0.5 * first_J);
}

TEST(ElectricJoint, GivesNoEnergyBackFromItsEndStops) {
  const LoadParams free{.mass = 1.2, .damping = 0.0};
  ElectricJoint joint = joint_at(drive(), free, {.position = 2.59, .velocity = 3.0, .rotor = 3.0});
  const double first_J = stored_energy_J(joint);
  bool hit = false;
  for (int tick = 0; tick < 500; ++tick) {
    const StepReport report = joint.step(0.0, 0.0, kPeriod_s);
    hit |= report.at_stop;
    ASSERT_LE(joint.state().position, 1.01 * drive().travel);
    ASSERT_LE(stored_energy_J(joint), first_J * (1.0 + 1e-6));
  }
  EXPECT_TRUE(hit);
}

TEST(ElectricJoint, RestsInItsEquilibriumUnderTheTorqueItHolds) {
  const LoadParams sprung{.mass = 1.2, .damping = 2.0, .stiffness = 300.0, .equilibrium_position = 1.2};
  for (const double torque : {-60.0, 0.0, 45.0}) {
    const ElectricState rest = equilibrium(drive(), sprung, 1.3, torque);
    ElectricJoint joint = joint_at(drive(), sprung, rest);
    for (int tick = 0; tick < 100; ++tick) {
      joint.step(rest.current_A, torque, kPeriod_s);
    }
    EXPECT_NEAR(joint.load_cell_force(), 300.0 * 0.1 - torque, 1e-9 * 100.0);
    EXPECT_NEAR(joint.state().velocity, 0.0, kRounding);
    EXPECT_NEAR(joint.state().position, 1.3, kRounding);
  }
}

TEST(ElectricJoint, StalledHasTheTorqueOfItsCurrent) {
  ElectricJoint joint = joint_at(drive(), {.mass = 1e6, .damping = 0.0}, {.position = 1.0});
  for (int tick = 0; tick < 2000; ++tick) {
    joint.step(12.0, 0.0, kPeriod_s);
  }
  // The load's own motion, 60 Nm on 1e6 kg m^2 for 2 s, is 1.2e-4 rad/s times D.
  EXPECT_NEAR(joint.load_cell_force(), output_constant(drive()) * 12.0, 1.2e-4 * (rotor_damping(drive()) + 40.0));
}

TEST(ElectricJoint, RunsFreeAtTheSpeedOfItsVoltage) {
  ElectricParams lossless = without_dry_friction();
  lossless.damping = 0.0;
  lossless.travel = 100.0;
  ElectricJoint joint = joint_at(lossless, {.mass = 0.12, .damping = 0.0}, {.position = 1.0});
  for (int tick = 0; tick < 1000; ++tick) {
    joint.step(150.0, 0.0, kPeriod_s);
  }
  EXPECT_NEAR(joint.state().velocity, 0.5 * no_load_speed(lossless), 1e-6 * no_load_speed(lossless));
  EXPECT_NEAR(joint.state().current_A, 0.0, 1e-6 * current_max_A(lossless));
}

TEST(ElectricJoint, ActsWithinItsVoltage) {
  ElectricJoint limited = joint_at(drive(), body(), {.position = 1.0});
  ElectricJoint beyond = limited;
  limited.step(current_max_A(drive()), 0.0, kPeriod_s);
  EXPECT_FALSE(beyond.step(10.0 * current_max_A(drive()), 0.0, kPeriod_s).input_refused);
  EXPECT_EQ(beyond.state().velocity, limited.state().velocity);
}

TEST(ElectricJoint, TakesInputsThatAreNotFiniteAsZero) {
  ElectricJoint still = joint_at(drive(), body(), {.position = 1.0, .velocity = 0.5});
  ElectricJoint told = still;
  still.step(0.0, 0.0, kPeriod_s);
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(told.step(kNan, kNan, kPeriod_s).input_refused);
  EXPECT_EQ(told.state().velocity, still.state().velocity);
  EXPECT_TRUE(told.step(0.0, 0.0, kNan).input_refused);
}

TEST(ElectricJoint, KeepsItsMotionWhenTheLoadJumps) {
  ElectricJoint joint = joint_at(drive(), leg(), {.position = 1.0});
  for (int tick = 0; tick < 20; ++tick) {
    joint.step(30.0, 0.0, kPeriod_s);
  }
  const ElectricState before = joint.state();
  const double torque = joint.load_cell_force();
  ASSERT_TRUE(joint.set_load(body()));
  EXPECT_EQ(joint.state().velocity, before.velocity);
  EXPECT_EQ(joint.load_cell_force(), torque);
  EXPECT_FALSE(joint.set_load({.mass = 0.0}));
  EXPECT_EQ(joint.load().mass, body().mass);
}

TEST(ElectricJoint, StaysFiniteUnderRandomCommandsWithoutAllocating) {
  ElectricJoint joint = joint_at(drive(), leg(), {.position = 1.0});
  const NoiseStream noise(7, "electric", "command");
  const farrier::test::AllocationGuard guard;
  for (int tick = 0; tick < 3000; ++tick) {
    const StepReport report = joint.step(current_max_A(drive()) * (2.0 * noise.uniform(tick / 20) - 1.0),
                                         200.0 * (2.0 * noise.uniform(100000 + tick / 50) - 1.0), kPeriod_s);
    ASSERT_FALSE(report.bound_hit);
    ASSERT_TRUE(finite(joint.state()));
    ASSERT_GT(joint.state().position, -0.02 * drive().travel);
    ASSERT_LT(joint.state().position, 1.02 * drive().travel);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

TEST(ElectricJoint, StatesAnErrorThatBoundsTheTrueOne) {
  ElectricJoint joint = joint_at(drive(), leg(), {.position = 1.0});
  const ElectricEquations equations(drive(), leg());
  const NoiseStream noise(3, "electric", "command");
  for (int tick = 0; tick < 300; ++tick) {
    const double command = 60.0 * (2.0 * noise.uniform(tick / 5) - 1.0);
    const ElectricState truth =
        test::reference_tick(equations, ElectricEquations::Input{command, 0.0}, joint.state(), kPeriod_s);
    const StepReport report = joint.step(command, 0.0, kPeriod_s);
    ASSERT_NEAR(joint.state().velocity, truth.velocity, report.error_velocity + kRounding) << "tick " << tick;
    ASSERT_NEAR(joint.state().position, truth.position, report.error_position + kRounding) << "tick " << tick;
  }
}

TEST(ElectricModel, IsTheJacobianOfTheEquations) {
  const LoadParams sprung{.mass = 0.3, .damping = 0.5, .stiffness = 200.0, .equilibrium_position = 1.0};
  const ElectricEquations equations(drive(), sprung);
  const auto values = [](const ElectricState& s) {
    return Eigen::Matrix<double, 5, 1>(s.position, s.velocity, s.deflection, s.rotor, s.current_A);
  };
  const auto state = [](const Eigen::Matrix<double, 5, 1>& x) { return ElectricState{x[0], x[1], x[2], x[3], x[4]}; };
  for (const double rotor : {0.0, 0.03, -1.5}) {
    const Eigen::Matrix<double, 5, 1> at(1.2, 0.7, 3e-3, rotor, 11.0);
    const StateSpace<5> model = linearise_full(drive(), sprung, rotor);
    const double scales[] = {1.0, 1.0, 1e-2, 1.0, 10.0};
    for (int i = 0; i < 5; ++i) {
      const double step = 1e-4 * scales[i];
      const Eigen::Matrix<double, 5, 1> by = step * Eigen::Matrix<double, 5, 1>::Unit(i);
      const Eigen::Matrix<double, 5, 1> slope = (values(equations.derivative(state(at + by), {5.0, 3.0})) -
                                                 values(equations.derivative(state(at - by), {5.0, 3.0}))) /
                                                (2.0 * step);
      // Central difference: step^2 / 6 of the third derivative of phi, at most 3 / w_s^3, and rounding.
      const double curved =
          step * step / 6.0 * 3.0 * drive().coulomb / std::pow(drive().slip_velocity, 3) / output_inertia(drive());
      const double rounding = 1e-7 * model.a.col(i).cwiseAbs().maxCoeff() + 1e-9;
      EXPECT_LE((slope - model.a.col(i)).cwiseAbs().maxCoeff(), curved + rounding) << "state " << i << " at " << rotor;
    }
    const Eigen::Matrix<double, 5, 1> by_command =
        values(equations.derivative(state(at), {6.0, 3.0})) - values(equations.derivative(state(at), {5.0, 3.0}));
    EXPECT_LE((by_command - model.b).cwiseAbs().maxCoeff(), 1e-9 * model.b.maxCoeff());
  }
}

TEST(ElectricModel, InThreeStatesFollowsTheJointAfterAStep) {
  const ElectricParams smooth = without_dry_friction();
  for (const LoadParams& load : {leg(), body()}) {
    const LinearModel model = linearise_load_cell_force(smooth, load);
    ElectricJoint joint = joint_at(smooth, load, {.position = 1.0});
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    double largest = 0.0;
    double apart = 0.0;
    constexpr int kParts = 50;
    for (int tick = 0; tick < 100; ++tick) {
      joint.step(5.0, 0.0, kPeriod_s);
      for (int part = 0; part < kParts; ++part) {  // midpoint rule
        const double h = kPeriod_s / kParts;
        const Eigen::Vector3d middle = x + 0.5 * h * (model.a * x + model.b * 5.0);
        x += h * (model.a * middle + model.b * 5.0);
      }
      largest = std::max(largest, std::abs(joint.load_cell_force()));
      apart = std::max(apart, std::abs(joint.load_cell_force() - x[2]));
    }
    // The rotor's lag J N^2 / D and the winding's L / R, over which the model's force runs ahead at its steepest.
    const double lag_s =
        output_inertia(smooth) / rotor_damping(smooth) + smooth.winding_inductance_H / smooth.winding_resistance_Ohm;
    EXPECT_LE(apart, 1.5 * lag_s * model.b[2] * 5.0) << "mass " << load.mass;
    EXPECT_LE(apart, 0.15 * largest) << "mass " << load.mass;
  }
}

TEST(ElectricModel, HasTheStalledJointsTorque) {
  const LinearModel model = linearise_load_cell_force(drive(), {.mass = 1e15, .damping = 0.0});
  EXPECT_NEAR(-model.b[2] / model.a(2, 2), output_constant(drive()), 1e-9);
}

TEST(ElectricJoint, RefusesWhatNoMachineHasAndNamesIt) {
  ElectricParams wrong = drive();
  wrong.winding_resistance_Ohm = -1.0;
  wrong.travel = 0.0;
  const auto refused = ElectricJoint::create(wrong, {.mass = 0.0}, {.position = 1.0});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("winding_resistance_Ohm = -1 must be finite and > 0"), std::string::npos);
  EXPECT_NE(refused.error().message.find("travel_rad = 0 must be finite and > 0"), std::string::npos);
}

TEST(ElectricJoint, RefusesASpringOnWhichTheRotorSwings) {
  ElectricParams stiff = drive();
  const double most = rotor_damping(stiff) * rotor_damping(stiff) / (4.0 * output_inertia(stiff));
  stiff.spring_stiffness = 0.99 * most;
  EXPECT_TRUE(validate(stiff).ok());
  stiff.spring_stiffness = 1.01 * most;
  const auto refused = validate(stiff);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("spring_stiffness_Nm_rad = 77"), std::string::npos) << refused.error().message;
}

TEST(ElectricJoint, RefusesALoadWithDryFriction) {
  LoadParams dry = body();
  dry.friction = {.coulomb = 1.0, .breakaway = 1.5};
  EXPECT_FALSE(ElectricJoint::create(drive(), dry, {.position = 1.0}).ok());
}

}  // namespace electric_test
}  // namespace farrier::plant
