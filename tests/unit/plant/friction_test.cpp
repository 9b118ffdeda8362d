#include <gtest/gtest.h>

#include <cmath>

#include "test_joints.hpp"

namespace farrier::plant {
namespace friction_test {

using test::kPeriod_s;

constexpr FrictionParams kGuide{40.0, 60.0, 0.01, 1e-5};

double rate(const Friction& friction, double force, double velocity) {
  Instant now{};
  now.velocity = velocity;
  Friction::X dx{};
  friction.after_valve(now, {force}, dx);
  EXPECT_EQ(now.load_force, -force);
  return dx[0];
}

TEST(Friction, InSteadySlidingIsStribecksCurve) {
  const Friction friction(kGuide, 2500.0, 0.3, 1e-6);
  for (const double v : {1e-4, 1e-3, 0.01, 0.02, 0.1}) {
    const double ratio = v / kGuide.stribeck_velocity;
    const double curve = kGuide.coulomb + (kGuide.breakaway - kGuide.coulomb) * std::exp(-ratio * ratio);
    const double scale = kGuide.breakaway / kGuide.presliding * v;  // of the two terms that cancel
    EXPECT_NEAR(rate(friction, curve, v), 0.0, 1e-14 * scale) << v;
    EXPECT_NEAR(rate(friction, -curve, -v), 0.0, 1e-14 * scale) << v;
    EXPECT_GT(rate(friction, 0.99 * curve, v), 0.0) << "friction below the curve must grow to it";
    EXPECT_LT(rate(friction, 1.01 * curve, v), 0.0) << "and above it fall";
  }
}

// f v - d/dt (f^2 z_s / (2 F_s)) = |v| f^2 / g: what the contact takes beyond what it stores is never negative.
TEST(Friction, GivesNoEnergy) {
  const Friction friction(kGuide, 2500.0, 0.3, 1e-6);
  for (double force = -60.0; force <= 60.0; force += 7.5) {
    for (const double v : {-0.2, -0.01, -1e-5, 0.0, 1e-5, 0.003, 0.2}) {
      const double stored = force * rate(friction, force, v) * kGuide.presliding / kGuide.breakaway;
      EXPECT_GE(force * v - stored, -1e-12 * std::abs(force * v)) << force << " N at " << v << " m/s";
    }
  }
}

// The bristles' damping is sigma_1 z', z' = f' / sigma_0; below 4 F_c / sigma_1 the contact gives no energy with it.
TEST(Friction, HasBristlesThatDamp) {
  FrictionParams damped = kGuide;
  damped.bristle_damping = 4.0 * kGuide.coulomb / 0.3;
  const Friction friction(damped, 2500.0, 0.3, 1e-6);
  const double stiffness = kGuide.breakaway / kGuide.presliding;
  for (double force = -60.0; force <= 60.0; force += 7.5) {
    for (const double v : {-0.3, -0.01, -1e-5, 0.0, 1e-5, 0.003, 0.3}) {
      Instant now{};
      now.velocity = v;
      Friction::X dx{};
      friction.after_valve(now, {force}, dx);
      const double bent = dx[0] / stiffness;
      EXPECT_NEAR(now.load_force, -force - damped.bristle_damping * bent, 1e-12 * (60.0 + std::abs(now.load_force)));
      if (std::abs(force) <= kGuide.coulomb) {
        EXPECT_GE(-now.load_force * v - force * bent, -1e-12 * std::abs(force * v)) << force << " N at " << v << " m/s";
      }
    }
  }
}

/// A mass on a guide: a cylinder too thin to matter (its oil is a spring of 80 N/m).
HydraulicJoint mass_on_guide(double stiffness = 0.0, double velocity = 0.0) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.area_a = actuator.area_b = 1e-6;
  actuator.valve_gain = 1e-9;
  actuator.piston_damping = 0.0;
  LoadParams load{2.5, stiffness > 0.0 ? 0.0 : 500.0, stiffness, 0.04};
  load.friction = kGuide;
  State start = equilibrium(actuator, load, 0.04, 0.0);
  start.velocity = velocity;
  return HydraulicJoint::create(actuator, load, start).value();
}

TEST(Friction, HoldsAForceBelowItsStaticOneWithoutCreep) {
  // A force that comes slowly bends the contact by -z_s ln(1 - F / F_s), where g = F_s (speeds far below v_s).
  HydraulicJoint joint = mass_on_guide();
  constexpr double kForce_N = 54.0;  // 0.9 F_s
  const double start_m = joint.state().position;
  for (int tick = 1; tick <= 1000; ++tick) {
    joint.step(0.0, kForce_N * tick / 1000.0, kPeriod_s);
  }
  double bent_m = joint.state().position - start_m;
  const double expected_m = -kGuide.presliding * std::log(1.0 - kForce_N / kGuide.breakaway);
  EXPECT_NEAR(bent_m, expected_m, 0.02 * expected_m);
  // Creep bound: the regularised sign function of same slope would give 0.9 v_0; this gives no more in ten seconds than
  // a hundredth of the presliding way, what the integrator's tolerance leaves.
  for (int tick = 0; tick < 500; ++tick) {
    joint.step(0.0, kForce_N, kPeriod_s);  // the rest of the ramp's transient
  }
  bent_m = joint.state().position - start_m;
  for (int tick = 0; tick < 10000; ++tick) {
    joint.step(0.0, kForce_N, kPeriod_s);
  }
  EXPECT_NEAR(joint.state().position - start_m, bent_m, 0.01 * kGuide.presliding);
}

TEST(Friction, LetsGoAtItsStaticForce) {
  for (const double direction : {1.0, -1.0}) {
    HydraulicJoint joint = mass_on_guide();
    const double start_m = joint.state().position;
    double let_go_N = 0.0;
    for (int tick = 0; tick < 8000 && let_go_N == 0.0; ++tick) {
      const double force_N = 0.01 * tick;
      joint.step(0.0, direction * force_N, kPeriod_s);
      if (std::abs(joint.state().position - start_m) > 10.0 * kGuide.presliding) {
        let_go_N = force_N;
      }
    }
    // -ln(1 - F / F_s) = 10 at F_s (1 - 5e-5); then the mass must gather way: 0.2 N more, 20 ms, by far.
    EXPECT_NEAR(let_go_N, kGuide.breakaway, 0.01 * kGuide.breakaway);
  }
}

TEST(Friction, StopsASpringAndLosesEnergyInEveryStep) {
  constexpr double kStiffness = 21480.0;
  HydraulicJoint joint = mass_on_guide(kStiffness, 0.3);
  const double mass = joint.load().mass + joint.actuator().piston_mass;
  const auto energy_J = [&] {
    const State& s = joint.state();
    const double off = s.position - 0.04;
    const double f = joint.effects().friction;
    return 0.5 * mass * s.velocity * s.velocity + 0.5 * kStiffness * off * off +
           0.5 * f * f * kGuide.presliding / kGuide.breakaway;
  };
  const double first_J = energy_J();
  double previous_J = first_J;
  for (int tick = 0; tick < 1000; ++tick) {
    const StepReport report = joint.step(0.0, 0.0, kPeriod_s);
    const State& s = joint.state();
    // The oil's 160 N/m swing with it; dE = M v dv + C x dx at the errors the step stated.
    const double tolerance_J = 160.0 / kStiffness * first_J +
                               mass * (std::abs(s.velocity) + 0.3) * report.error_velocity +
                               kStiffness * 0.01 * report.error_position;
    ASSERT_LE(energy_J(), previous_J + tolerance_J) << "tick " << tick;
    previous_J = energy_J();
  }
  // Coulomb friction stops a spring within F_s / C of slack.
  EXPECT_LE(std::abs(joint.state().position - 0.04), kGuide.breakaway / kStiffness);
  EXPECT_NEAR(joint.state().velocity, 0.0, 1e-4);
}

TEST(Friction, OfALoadThatIsTakenAwayIsGone) {
  HydraulicJoint joint = mass_on_guide();
  for (int tick = 0; tick < 100; ++tick) {
    joint.step(0.0, 30.0, kPeriod_s);
  }
  ASSERT_GT(joint.effects().friction, 20.0);
  LoadParams smooth = joint.load();
  smooth.friction = {};
  ASSERT_TRUE(joint.set_load(smooth));
  EXPECT_EQ(joint.effects().friction, 0.0);
  LoadParams sticky = smooth;
  sticky.friction = {10.0, 20.0, 0.01, 1e-5};
  ASSERT_TRUE(joint.set_load(sticky));
  joint.step(0.0, 5.0, kPeriod_s);
  EXPECT_NE(joint.effects().friction, 0.0);
  EXPECT_LE(std::abs(joint.effects().friction), 20.0);
}

TEST(Friction, ActsOnTheLoadsSideOfTheLoadCell) {
  // A load held by friction alone: the cell must not feel the external force that friction takes.
  HydraulicJoint joint = mass_on_guide();
  const double before_N = joint.load_cell_force();
  for (int tick = 1; tick <= 1000; ++tick) {
    joint.step(0.0, 0.03 * tick, kPeriod_s);
  }
  for (int tick = 0; tick < 500; ++tick) {
    joint.step(0.0, 30.0, kPeriod_s);
  }
  EXPECT_NEAR(joint.effects().friction, 30.0, 0.1);
  EXPECT_NEAR(joint.load_cell_force(), before_N, 0.1);
}

}  // namespace friction_test
}  // namespace farrier::plant
