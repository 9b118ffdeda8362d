// An electric joint without a spring: its equations, limits and linear model.

#include <gtest/gtest.h>

#include <cmath>

#include "plant/electric_joint.hpp"
#include "tests/unit/plant/test_drive.hpp"

namespace farrier::plant {
namespace rigid_drive_test {

constexpr double kPeriod_s = 1e-3;
constexpr double kTolerance = ElectricJoint::kDefaultTolerance;  // of current and speed, relative to their largest

// Torque up to 23.7 Nm, speed up to 30 rad/s (fading over 5 % of it), armature 0.01 kg m^2.
ElectricParams by_limits() {
  ElectricParams params{.torque_constant_Nm_A = 1.0,
                        .winding_resistance_Ohm = 0.05 * 30.0 / 23.7,
                        .supply_voltage_V = 1.05 * 30.0,
                        .rotor_inertia_kg_m2 = 0.01,
                        .gear_ratio = 1.0,
                        .slip_velocity = 0.05,
                        .travel = 100.0,
                        .stop_stiffness = 1e3,
                        .rigid = true,
                        .torque_time_constant_s = 1e-3,
                        .current_limit_A = 23.7};
  return params;
}

ElectricJoint joint_of(const ElectricParams& params, const LoadParams& load, const ElectricState& initial = {}) {
  return ElectricJoint::create(params, load, initial).value();
}

TEST(RigidDrive, IsALagBeforeOneInertiaOfRotorAndLoad) {
  ElectricJoint joint = joint_of(by_limits(), {.mass = 0.03, .damping = 0.0}, {.position = 1.0});
  joint.step(2.0, 0.0, kPeriod_s);
  const double decayed = std::exp(-1.0);
  EXPECT_NEAR(joint.load_cell_force(), 2.0 * (1.0 - decayed), 23.7 * kTolerance);
  // v = (T / m) (t - tau (1 - exp(-t / tau))) with m = 0.03 + 0.01.
  EXPECT_NEAR(joint.state().velocity, 2.0 / 0.04 * kPeriod_s * decayed, 31.5 * kTolerance);
}

TEST(RigidDrive, FollowsItsLinearModelWithoutDryFriction) {
  ElectricParams params = by_limits();
  params.damping = 0.2;
  const LoadParams load{.mass = 0.05, .damping = 0.1, .stiffness = 3.0, .equilibrium_position = 1.0};
  ElectricJoint joint = joint_of(params, load, {.position = 1.0});
  const LinearModel model = linearise_load_cell_force(params, load);
  Eigen::Vector3d state = Eigen::Vector3d::Zero();
  constexpr int kParts = 1000;
  for (int tick = 0; tick < 50; ++tick) {
    joint.step(1.5, 0.0, kPeriod_s);
    for (int part = 0; part < kParts; ++part) {  // Euler, error of the order of its step
      state += (model.a * state + model.b * 1.5) * (kPeriod_s / kParts);
    }
  }
  EXPECT_NEAR(joint.state().position - 1.0, state[0], 1e-4 * state[0]);
  EXPECT_NEAR(joint.state().velocity, state[1], 1e-4 * state[1]);
  EXPECT_NEAR(joint.load_cell_force(), state[2], 1e-4 * state[2]);
}

TEST(RigidDrive, NeverExceedsItsTorqueAndItsSpeed) {
  ElectricJoint joint = joint_of(by_limits(), {.mass = 0.03, .damping = 0.0});
  double torque = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    joint.step(1000.0, 0.0, kPeriod_s);
    torque = std::max(torque, std::abs(joint.load_cell_force()));
  }
  EXPECT_LE(torque, 23.7 * (1.0 + 1e-6));
  EXPECT_NEAR(joint.state().velocity, 1.05 * 30.0, 0.1);
}

TEST(RigidDrive, HasItsFullTorqueUpToItsSpeed) {
  const ElectricEquations equations(by_limits(), {.mass = 0.03});
  const auto approached_A = [&](double velocity) {
    const ElectricState state{.position = 50.0, .velocity = velocity};
    return equations.derivative(state, {1000.0, 0.0}).current_A * by_limits().torque_time_constant_s;
  };
  EXPECT_NEAR(approached_A(0.0), 23.7, 1e-9);
  EXPECT_NEAR(approached_A(29.9), 23.7, 1e-9);
  EXPECT_NEAR(approached_A(31.5), 0.0, 1e-9);
  EXPECT_LT(approached_A(32.0), 0.0) << "the back-EMF brakes";
}

TEST(RigidDrive, LeavesItsRotorToAMechanismThatItFollows) {
  ElectricParams params = by_limits();
  params.coulomb = 0.2;
  ElectricJoint joint = joint_of(params, {.mass = 0.03}, {.position = 1.0, .current_A = 3.0});
  ElectricAccount account;
  joint.follow(3.0, {1.0 + 2e-3, 2.0}, kPeriod_s, account);
  EXPECT_NEAR(joint.load_cell_force(), 3.0, 1e-9);
  EXPECT_NEAR(joint.mechanism_force(), 3.0 - 0.2, 1e-3) << "less the dry friction, without the rotor's inertia";
  EXPECT_NEAR(account.work_J, (3.0 - 0.2) * 2e-3, 1e-4);
}

TEST(RigidDrive, RestsInItsEquilibrium) {
  const LoadParams sprung{.mass = 0.05, .damping = 0.1, .stiffness = 30.0, .equilibrium_position = 1.2};
  const ElectricState rest = equilibrium(by_limits(), sprung, 1.3, -2.0);
  ElectricJoint joint = joint_of(by_limits(), sprung, rest);
  for (int tick = 0; tick < 100; ++tick) {
    joint.step(rest.current_A, -2.0, kPeriod_s);
  }
  EXPECT_NEAR(joint.load_cell_force(), 30.0 * 0.1 + 2.0, 1e-9);
  EXPECT_NEAR(joint.state().position, 1.3, 1e-9);
}

TEST(RigidDrive, NeedsNeitherWindingNorSpringButATimeConstant) {
  EXPECT_TRUE(validate(by_limits()).ok());
  ElectricParams immediate = by_limits();
  immediate.torque_time_constant_s = 0.0;
  const auto refused = validate(immediate);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message.find("torque_time_constant_s = 0 must be finite and > 0"), std::string::npos);
}

}  // namespace rigid_drive_test
}  // namespace farrier::plant
