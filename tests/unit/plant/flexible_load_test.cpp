// A part of the load's mass on a spring, against its energy and against Duhamel's integral.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "test_effects.hpp"

namespace farrier::plant {
namespace flexible_load_test {

using test::effect_of;
using test::joint_with;
using test::kPeriod_s;
using test::same;

const ActuatorParams kCylinder = test::hyq_cylinder();
const LoadParams kLoad = test::swing_load();
constexpr double kShare = 0.4;
constexpr double kOmega_rad_s = 75.0;
constexpr double kDamping = 0.05;

ActiveEffect flexible(double share) {
  return effect_of("flexible_load", {share, kOmega_rad_s, kDamping}, kCylinder, kLoad);
}

TEST(FlexibleLoad, ChangesNoBitWithoutAShare) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {flexible(0.0)});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  FlexibleLoad<double> term(std::array{0.0, kOmega_rad_s, kDamping}.data(), Scales(kCylinder, kLoad), kPeriod_s);
  for (int tick = 0; tick < 200; ++tick) {
    const double current = 0.004 * std::sin(0.05 * tick);
    with.step(current, 20.0, kPeriod_s);
    nominal.step(current, 20.0, kPeriod_s);
    ASSERT_TRUE(same(with, nominal)) << tick;
    LoadMoment<double> moment{0.04, nominal.state().velocity, 2.5, 100.0, 0.0, 0.0, 0.0, 3.0, 7.0};
    term.on_load(moment);
    term.after_load(nominal.state().velocity);
    ASSERT_EQ(moment.mass, 2.5);
    ASSERT_EQ(moment.hold, 3.0);
    ASSERT_EQ(moment.slope, 7.0);
  }
}

// r = -Im(z) / w_d with z' = l z + v', l = -D w + i w_d: Duhamel's integral of the load's acceleration.
TEST(FlexibleLoad, PullsAsDuhamelsIntegralOfTheMotionSays) {
  constexpr double kStep_s = 2.5e-5;
  HydraulicJoint joint = joint_with(kCylinder, kLoad, {flexible(kShare)}, 1e-9);
  const double swinging_rad_s = kOmega_rad_s * std::sqrt(1.0 - kDamping * kDamping);
  const std::complex<double> pole(-kDamping * kOmega_rad_s, swinging_rad_s);
  const double part_kg = kShare * kLoad.mass;
  std::complex<double> z;
  double before = joint.acceleration();
  double largest_N = 0.0;
  double largest_pull_N = 0.0;
  double largest_error_N = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double current = 0.003 * std::sin(2.0 * std::numbers::pi * (3.0 + 5e-4 * i) * i * kStep_s);
    joint.step(current, 0.0, kStep_s);
    // The current jumps at the step's beginning, the acceleration does not.
    z = std::exp(pole * kStep_s) * (z + 0.5 * kStep_s * before) + 0.5 * kStep_s * joint.acceleration();
    before = joint.acceleration();
    const double way = -z.imag() / swinging_rad_s;
    const double rate = -(pole * z).imag() / swinging_rad_s;
    const double pull = part_kg * kOmega_rad_s * (kOmega_rad_s * way + 2.0 * kDamping * rate);
    const double cell = (kLoad.mass - part_kg) * joint.acceleration() + kLoad.damping * joint.state().velocity - pull;
    largest_error_N = std::max(largest_error_N, std::abs(joint.load_cell_force() - cell));
    largest_pull_N = std::max(largest_pull_N, std::abs(pull));
    largest_N = std::max(largest_N, std::abs(cell));
  }
  EXPECT_GT(largest_pull_N, 5.0);
  EXPECT_LT(largest_error_N, 1e-3 * largest_N);
}

TEST(FlexibleLoad, TakesFromTheLoadWhatItStoresAndWhatItsDamperLoses) {
  const FlexiblePart part({kShare, kOmega_rad_s, kDamping}, 2.5, 0.08, 0.5);
  const double mass = kShare * 2.5;
  const NoiseStream draw(3, "flexible_load_test", "states");
  for (Tick i = 0; i < 300; i += 3) {
    Instant now{};
    now.velocity = draw.normal(i);
    const FlexiblePart::X x{0.01 * draw.normal(i + 1), draw.normal(i + 2)};
    FlexiblePart::X dx{};
    part.after_valve(now, x, dx);
    const double stored = mass * (x[1] * dx[1] + kOmega_rad_s * kOmega_rad_s * x[0] * dx[0]);
    const double lost = 2.0 * kDamping * kOmega_rad_s * mass * dx[0] * dx[0];
    const double taken = -now.load_force * now.velocity;
    EXPECT_NEAR(taken, stored + lost, 1e-12 * (std::abs(taken) + std::abs(stored) + lost));
  }
}

/// A load on a spring, with its part on another, as a fit steps them. The part's motion follows from its force.
class SteppedLoad {
 public:
  SteppedLoad(double omega_rad_s, double damping, double step_s)
      : term_(std::array{kShare, omega_rad_s, damping}.data(), Scales(kCylinder, kLoad), step_s),
        omega_rad_s_(omega_rad_s),
        step_s_(step_s) {}

  double energy_J() const {
    return 0.5 * ((kMass_kg - kPart_kg) * v_ * v_ + kStiffness * x_ * x_) +
           0.5 * kPart_kg * (u_ * u_ + omega_rad_s_ * omega_rad_s_ * way_ * way_);
  }
  void step() {
    LoadMoment<double> load{x_ + 0.5 * step_s_ * v_, v_, kMass_kg, 0.0, kStiffness, 0.0, 0.0, 0.0, 0.0};
    term_.on_load(load);
    const double mass = 2.0 / step_s_ * load.mass;
    const double mean = (mass * v_ - kStiffness * x_ - load.hold) / (mass + load.slope + 0.5 * step_s_ * kStiffness);
    term_.after_load(mean);
    const double part_mean = u_ + 0.5 * step_s_ * (load.hold + load.slope * mean) / kPart_kg;
    way_ += step_s_ * (part_mean - mean);
    u_ += 2.0 * (part_mean - u_);
    x_ += step_s_ * mean;
    v_ += 2.0 * (mean - v_);
  }

 private:
  static constexpr double kMass_kg = 2.5;
  static constexpr double kPart_kg = kShare * kMass_kg;
  static constexpr double kStiffness = 2e4;
  FlexibleLoad<double> term_;
  double omega_rad_s_, step_s_;
  double x_ = 0.0, v_ = 1.0, way_ = 0.0, u_ = 1.0;
};

TEST(FlexibleLoad, SteppedNeverGainsEnergyAtAnyFrequency) {
  for (const double step_s : {2.5e-4, 5e-3}) {
    for (const double omega : {12.0, 75.0, 400.0}) {
      SteppedLoad lossless(omega, 0.0, step_s);
      SteppedLoad damped(omega, kDamping, step_s);
      const double first_J = lossless.energy_J();
      for (int step = 0; step < 2000; ++step) {
        const double before_J = damped.energy_J();
        lossless.step();
        damped.step();
        ASSERT_NEAR(lossless.energy_J(), first_J, 1e-9 * first_J);
        ASSERT_LE(damped.energy_J(), before_J + 1e-12 * first_J);
      }
      EXPECT_LT(damped.energy_J(), 0.99 * first_J) << omega << ' ' << step_s;
    }
  }
}

TEST(FlexibleLoad, StaysWithItsShareWhenTheLoadChanges) {
  HydraulicJoint joint = joint_with(kCylinder, kLoad, {flexible(kShare)});
  ASSERT_TRUE(joint.set_load(test::stance_load()));
  EXPECT_EQ(joint.load().flexible.share, kShare);
  EXPECT_EQ(joint.load().mass, test::stance_load().mass);
}

TEST(FlexibleLoad, IsLeftToAMechanismThatMovesThePiston) {
  HydraulicJoint with = joint_with(kCylinder, kLoad, {flexible(kShare)});
  HydraulicJoint nominal = joint_with(kCylinder, kLoad, {});
  OilAccount account;
  for (int tick = 0; tick < 100; ++tick) {
    const Motion end{0.04 + 0.005 * std::sin(0.1 * tick), 0.5 * std::cos(0.1 * tick)};
    with.follow(0.001, kCylinder.supply_pressure_Pa, end, kPeriod_s, account);
    nominal.follow(0.001, kCylinder.supply_pressure_Pa, end, kPeriod_s, account);
    ASSERT_EQ(with.mechanism_force(), nominal.mechanism_force()) << tick;
  }
}

TEST(FlexibleLoad, RefusesTheWholeMass) {
  const ActiveEffect all = flexible(1.0);
  const auto joint =
      HydraulicJoint::create(kCylinder, kLoad, equilibrium(kCylinder, kLoad, 0.04, 0.0), 1e-6, std::span(&all, 1));
  ASSERT_FALSE(joint.ok());
  EXPECT_NE(joint.error().message.find("share"), std::string::npos) << joint.error().message;
}

}  // namespace flexible_load_test
}  // namespace farrier::plant
