#include "plant/oil.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "plant/coulomb_friction.hpp"
#include "plant/equations.hpp"
#include "test_joints.hpp"

namespace farrier::plant {
namespace oil_test {

/// A number with its derivative, as fits have it.
struct Dual {
  double a = 0.0, d = 0.0;
  Dual() = default;
  Dual(double value, double derivative = 0.0) : a(value), d(derivative) {}
};
Dual operator*(const Dual& x, const Dual& y) { return {x.a * y.a, x.d * y.a + x.a * y.d}; }
Dual operator/(const Dual& x, const Dual& y) { return {x.a / y.a, (x.d - x.a / y.a * y.d) / y.a}; }
Dual operator+(const Dual& x, const Dual& y) { return {x.a + y.a, x.d + y.d}; }
Dual operator-(const Dual& x, const Dual& y) { return {x.a - y.a, x.d - y.d}; }
bool operator>(const Dual& x, const Dual& y) { return x.a > y.a; }
Dual sqrt(const Dual& x) { return {std::sqrt(x.a), 0.5 * x.d / std::sqrt(x.a)}; }

constexpr std::array kDrops_Pa{-2e7, -3e5, -1e5, -10.0, 0.0, 2e4, 1e5, 1e6, 2.5e7};

TEST(PortFlow, FallsWithTheChambersPressureByItsSlope) {
  constexpr double kGain = 6.7e-8;
  for (const double drop : kDrops_Pa) {
    const auto flow = port_flow(kGain, drop, 1e5);
    EXPECT_EQ(flow.flow, kGain * drop / orifice_divisor(drop, 1e5));
    const Dual by_pressure = port_flow(Dual(kGain), Dual(drop, -1.0), 1e5).flow;
    EXPECT_EQ(by_pressure.a, flow.flow);
    EXPECT_NEAR(-by_pressure.d, flow.slope, 1e-14 * flow.slope) << drop;
    EXPECT_GT(flow.slope, 0.0);
  }
}

TEST(PortPressures, CarryTheSignOfTheCurrent) {
  EXPECT_EQ(port_pressures(true, 250e5, 1e5).a_Pa, 250e5);
  EXPECT_EQ(port_pressures(true, 250e5, 1e5).b_Pa, 1e5);
  EXPECT_EQ(port_pressures(false, 250e5, 1e5).a_Pa, 1e5);
  EXPECT_EQ(port_pressures(false, 250e5, 1e5).b_Pa, 250e5);
}

TEST(ChamberVolumes, ShareTheStrokeAndKeepAQuarterOfTheLine) {
  const ActuatorParams act = test::hyq_cylinder();
  for (const double x : {-0.01, 0.0, 0.03, act.stroke}) {
    const auto volumes = chamber_volumes(act, x);
    EXPECT_DOUBLE_EQ(volumes.a_m3 / act.area_a + volumes.b_m3 / act.area_b,
                     act.line_volume_m3 / act.area_a + act.line_volume_m3 / act.area_b + act.stroke);
    const auto by_position = chamber_volumes(act, Dual(x, 1.0));
    EXPECT_EQ(by_position.a_m3.a, volumes.a_m3);
    EXPECT_DOUBLE_EQ(by_position.a_m3.d, act.area_a);
    EXPECT_DOUBLE_EQ(by_position.b_m3.d, -act.area_b);
  }
  const double smallest = kSmallestVolumeShare * act.line_volume_m3;
  EXPECT_EQ(at_least(smallest, chamber_volumes(act, -1.0)).a_m3, smallest);
  EXPECT_EQ(at_least(smallest, chamber_volumes(act, 1.0)).b_m3, smallest);
}

TEST(PressureRate, IsTheSameForAFlowAndForItsFraction) {
  constexpr double kBulkModulus = 1.3e9, kVolume = 4e-6, kFlow = 2e-5, kRoot = 4.5e3, kGrowth = 7e-6;
  const double whole = pressure_rate(kBulkModulus / kVolume, kFlow, kGrowth);
  EXPECT_NEAR(pressure_rate(kBulkModulus, kVolume, kFlow * kRoot, kRoot, kGrowth), whole, 1e-12 * whole);
}

TEST(SmoothSign, HasTheSlopeOfCoulombFriction) {
  for (const double v : {-0.5, -1e-3, 0.0, 4e-3, 0.2}) {
    constexpr double kSlip = 5e-3;
    constexpr double kStep = 1e-7;
    const SmoothSign sign = smooth_sign(v, kSlip);
    EXPECT_DOUBLE_EQ(40.0 * sign.value, coulomb_friction(40.0, v, kSlip));
    const double slope = (smooth_sign(v + kStep, kSlip).value - smooth_sign(v - kStep, kSlip).value) / (2.0 * kStep);
    EXPECT_NEAR(sign.slope, slope, 1e-5 / kSlip) << v;
  }
}

TEST(StopPush, HasTheSlopesThatItsForceHas) {
  constexpr double kStiffness = 2e7, kDamping = 1e4, kSteepness = 1e4, kStep = 1e-9;
  const auto push = [](double depth, double speed) {
    return stop_push(depth, speed, depth * kSteepness, kStiffness, kDamping);
  };
  for (const double depth : {2e-5, 7e-5, 3e-4}) {
    for (const double speed : {-1.0, -0.01, 0.0, 0.1}) {
      const StopPush at = stop_push_and_slopes(depth, speed, kSteepness, kStiffness, kDamping);
      EXPECT_EQ(at.force, push(depth, speed));
      EXPECT_NEAR(at.by_depth, (push(depth + kStep, speed) - push(depth - kStep, speed)) / (2.0 * kStep), 1e-4 * 2e7);
      EXPECT_NEAR(at.by_speed, (push(depth, speed + 1e-6) - push(depth, speed - 1e-6)) / 2e-6, 1e-3 * kDamping);
    }
  }
}

// The cut at the load cell: each half gets of the other what crosses the cell, and both together are the joint.
TEST(Halves, MakeTheJointBitForBit) {
  const ActuatorParams act = test::hyq_cylinder();
  const LoadParams load = test::swing_load();
  const JointEquations joint(act, load);
  const ActuatorEquations left(act);
  const LoadEquations right(load, act.piston_mass, act.piston_damping);
  for (const IntegrationState& s : {IntegrationState{0.04, 0.1, 60e5, 90e5}, IntegrationState{-1e-5, -0.2, -1e5, 2e7},
                                    IntegrationState{act.stroke + 2e-5, 0.3, 3e5, 1.0}}) {
    for (const double current : {-0.01, 0.0, 0.004}) {
      const OpenValve valve = left.hold(current);
      const double p_a = pressure_of(s.compression_a_Pa);
      const double p_b = pressure_of(s.compression_b_Pa);
      const CompressionRates rates = left.compression_rates(
          s.position, s.velocity, s.compression_a_Pa, s.compression_b_Pa, p_a, p_b, left.valve_flow(p_a, p_b, valve));
      const double acceleration = right.acceleration(s.position, s.velocity, hydraulic_force(act, p_a, p_b), 30.0,
                                                     left.stop_force(s.position, s.velocity));
      const IntegrationState whole = joint.derivative(s, joint.hold(current, 30.0));
      EXPECT_EQ(whole.velocity, acceleration);
      EXPECT_EQ(whole.compression_a_Pa, rates.a_Pa_s);
      EXPECT_EQ(whole.compression_b_Pa, rates.b_Pa_s);
    }
  }
}

}  // namespace oil_test
}  // namespace farrier::plant
