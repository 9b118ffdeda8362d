#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "test_joints.hpp"

namespace farrier::plant {
namespace lines_test {

constexpr double kSample_s = 1e-5;
constexpr LineParams kLine{.length_m = 0.6};  // of 3.8 mm, as the rig's

/// A load nothing moves: the chambers' volumes stand still.
LoadParams wall() { return {1e7, 1e5, 0.0, 0.0}; }

struct Swing {
  double frequency_Hz;
  double decay_1_s;
};

/// Valve open for a tenth of a millisecond, then shut: the line is left to swing. Frequency from the zero crossings of
/// its flow, decay from the flow's extremes.
Swing swing_of(const ActuatorParams& actuator, int samples) {
  HydraulicJoint joint = test::joint_at_rest(actuator, wall(), 1e-9);
  joint.step(0.5 * actuator.valve_current_max_A, 0.0, 1e-4);
  double previous = joint.effects().line_flow_a_m3_s;
  double extreme = 0.0;
  std::vector<double> crossings;
  std::vector<double> extremes;
  for (int i = 1; i <= samples; ++i) {
    joint.step(0.0, 0.0, kSample_s);
    const double flow = joint.effects().line_flow_a_m3_s;
    if ((flow > 0.0) != (previous > 0.0)) {
      crossings.push_back((i - 1 + previous / (previous - flow)) * kSample_s);
      extremes.push_back(extreme);
      extreme = 0.0;
    }
    extreme = std::max(extreme, std::abs(flow));
    previous = flow;
  }
  const auto halves = static_cast<double>(crossings.size() - 1);
  const double span_s = crossings.back() - crossings.front();
  return {0.5 * halves / span_s, std::log(extremes[1] / extremes.back()) /
                                     (span_s * static_cast<double>(extremes.size() - 2) / halves)};
}

struct Analytic {
  double inertia, resistance, valve_side, chamber_side;  // I, R, and volumes
};
Analytic analytic(const ActuatorParams& actuator) {
  const LineParams& l = actuator.line;
  const double area = bore_area_m2(l);
  const double valve_side = valve_side_volume_m3(l);
  return {l.density_kg_m3 * l.length_m / area,
          128.0 * l.viscosity_Pa_s * l.length_m / (std::numbers::pi * std::pow(l.bore_m, 4)), valve_side,
          actuator.line_volume_m3 - valve_side + actuator.area_a * 0.5 * actuator.stroke};
}

// I q'' + R q' + beta_e (1 / V_v + 1 / V_a) q = 0
TEST(Lines, SwingAtTheirAnalyticFrequencyAndDecay) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.line = kLine;
  const Analytic a = analytic(actuator);
  const double stiffness = actuator.bulk_modulus_Pa * (1.0 / a.valve_side + 1.0 / a.chamber_side);
  const double decay_1_s = 0.5 * a.resistance / a.inertia;
  const double omega = std::sqrt(stiffness / a.inertia - decay_1_s * decay_1_s);
  const Swing swing = swing_of(actuator, 4000);
  EXPECT_NEAR(swing.frequency_Hz, omega / (2.0 * std::numbers::pi), 1e-3 * swing.frequency_Hz);
  EXPECT_NEAR(swing.decay_1_s, decay_1_s, 0.02 * decay_1_s);  // extremes are read at samples: within 1 - cos(w h / 2)
}

// Into a chamber so large that its pressure is constant the line's first mode is the quarter wave, c / (4 L).
TEST(Lines, HaveTheQuarterWaveOfATrueLineBeforeALargeChamber) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.line = kLine;
  actuator.line_volume_m3 = 1e-3;
  const double speed = std::sqrt(actuator.bulk_modulus_Pa / kLine.density_kg_m3);
  // The chamber's 1 l beside 2.8 ml behind the valve: 1 + 0.0027 in the square.
  const double quarter_Hz = speed / (4.0 * kLine.length_m);
  EXPECT_NEAR(swing_of(actuator, 4000).frequency_Hz, quarter_Hz, 3e-3 * quarter_Hz);
}

// V_v c_v + V_a c_a is constant where volumes are: (2.10) with the line's flow from one to the other.
TEST(Lines, KeepTheOilThatIsInThemWhenTheValveIsShut) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.line = kLine;
  const Analytic a = analytic(actuator);
  HydraulicJoint joint = test::joint_at_rest(actuator, wall());
  joint.step(0.5 * actuator.valve_current_max_A, 0.0, 1e-4);
  const auto oil = [&] {
    return a.valve_side * joint.effects().line_pressure_a_Pa + a.chamber_side * joint.state().pressure_a_Pa;
  };
  const double before = oil();
  double summed_error_Pa = 0.0;
  for (int tick = 0; tick < 300; ++tick) {
    summed_error_Pa += joint.step(0.0, 0.0, test::kPeriod_s).error_pressure_Pa;
    ASSERT_NEAR(oil(), before, (a.valve_side + a.chamber_side) * summed_error_Pa);
  }
}

// E = V_v p_v^2 / (2 beta) + V_a p_a^2 / (2 beta) + I q^2 / 2 with E' = -R q^2 where volumes stand still.
TEST(Lines, OnlyLoseEnergyWhenTheValveIsShut) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.line = kLine;
  actuator.line.loss_coefficient = 5.0;
  const Analytic a = analytic(actuator);
  HydraulicJoint joint = test::joint_at_rest(actuator, wall());
  joint.step(0.5 * actuator.valve_current_max_A, 0.0, 1e-4);
  const auto energy_J = [&] {
    const EffectReadings e = joint.effects();
    const double p = joint.state().pressure_a_Pa;
    return (a.valve_side * e.line_pressure_a_Pa * e.line_pressure_a_Pa + a.chamber_side * p * p) /
               (2.0 * actuator.bulk_modulus_Pa) +
           0.5 * a.inertia * e.line_flow_a_m3_s * e.line_flow_a_m3_s;
  };
  double previous_J = energy_J();
  const double first_J = previous_J;
  for (int i = 0; i < 2000; ++i) {
    const StepReport report = joint.step(0.0, 0.0, kSample_s);
    const double tolerance_J = (a.valve_side + a.chamber_side) * actuator.supply_pressure_Pa / actuator.bulk_modulus_Pa *
                               report.error_pressure_Pa + 1e-12 * first_J;
    ASSERT_LE(energy_J(), previous_J + tolerance_J) << "sample " << i;
    previous_J = energy_J();
  }
  EXPECT_LT(previous_J, first_J);
}

TEST(Lines, RefillTheirVoidsBeforePressureRises) {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.line = kLine;
  HydraulicJoint joint = test::joint_at_rest(actuator, test::swing_load());
  bool void_seen = false;
  for (int tick = 0; tick < 400; ++tick) {
    joint.step(0.0, tick < 200 ? 9000.0 : -500.0, test::kPeriod_s);
    const double space = joint.void_volume_a_m3();
    ASSERT_GE(space, 0.0);
    ASSERT_GE(joint.effects().line_pressure_a_Pa, 0.0);
    void_seen |= space > 0.0;
  }
  EXPECT_TRUE(void_seen);
  EXPECT_EQ(joint.void_volume_a_m3(), 0.0);
}

// The oil's inertia matters above its resonance alone: a slow motion loses R Q of its pressure drop and no more.
TEST(Lines, AreNotFeltInASlowMotionBeyondTheirLaminarLoss) {
  ActuatorParams lined = test::rig_cylinder();
  lined.line = kLine;
  HydraulicJoint with = test::joint_at_rest(lined, test::stance_load());
  HydraulicJoint without = test::joint_at_rest(test::rig_cylinder(), test::stance_load());
  for (int tick = 0; tick < 800; ++tick) {
    with.step(0.001, 0.0, test::kPeriod_s);
    without.step(0.001, 0.0, test::kPeriod_s);
  }
  const double v = without.state().velocity;
  const double flow = v * lined.area_a;
  // Flow goes with the root of the drop: half the relative loss of both lines against the supply.
  const double share = analytic(lined).resistance * flow / lined.supply_pressure_Pa;
  EXPECT_GT(v, 0.0);
  EXPECT_LT(with.state().velocity, v);
  EXPECT_NEAR(with.state().velocity / v, 1.0, 2.0 * share + 1e-3);
}

}  // namespace lines_test
}  // namespace farrier::plant
