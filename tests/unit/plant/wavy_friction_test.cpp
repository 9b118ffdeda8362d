// Friction that swings with the position, in the plant and in the term that fits use.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "test_effects.hpp"

namespace farrier::plant {
namespace wavy_friction_test {

using test::effect_of;
using test::kPeriod_s;

constexpr double kCoulomb_N = 40.0, kRatio = 1.4, kStribeck_m_s = 0.01, kPresliding_m = 6e-5;
constexpr double kWaviness = 0.6, kWavelength_m = 0.013, kTightest_m = 0.047;
constexpr double kStiffness_N_m = 5000.0, kDamping_Ns_m = 30.0, kMiddle_m = 0.04;

/// A cylinder too thin to matter: its oil is a spring of 160 N/m.
ActuatorParams thin_cylinder() {
  ActuatorParams actuator = test::rig_cylinder();
  actuator.area_a = actuator.area_b = 1e-6;
  actuator.valve_gain = 1e-9;
  actuator.piston_damping = 0.0;
  return actuator;
}
LoadParams sprung_load() { return {2.5, kDamping_Ns_m, kStiffness_N_m, kMiddle_m}; }

ActiveEffect wave(double waviness = kWaviness) {
  return effect_of("position_dependent_friction",
                   {kCoulomb_N, kRatio, kStribeck_m_s, kPresliding_m, 0.0, waviness, kWavelength_m, kTightest_m},
                   thin_cylinder(), sprung_load());
}

/// Below the force that a joint takes, ten times its own.
double push(double time_s) { return 120.0 * std::sin(20.0 * time_s); }

/// Position, velocity and force of the bristles, by the equations of the contact written out.
struct Independent {
  double x = kMiddle_m, v = 0.0, f = 0.0;

  std::array<double, 3> rates(double time_s, const std::array<double, 3>& s, double mass, double oil) const {
    const auto [x, v, f] = s;
    const double level = 1.0 + kWaviness * std::cos(2.0 * std::numbers::pi * (x - kTightest_m) / kWavelength_m);
    const double r = v / kStribeck_m_s;
    const double steady = level * kCoulomb_N * (1.0 + (kRatio - 1.0) * std::exp(-r * r));
    const double bends = kRatio * kCoulomb_N / kPresliding_m;
    return {v, (push(time_s) - kDamping_Ns_m * v - (kStiffness_N_m + oil) * (x - kMiddle_m) - f) / mass,
            bends * (v - std::abs(v) * f / steady)};
  }
  /// A classical Runge-Kutta step of fourth order.
  void step(double time_s, double h, double mass, double oil) {
    const std::array<double, 3> s{x, v, f};
    const auto at = [&](const std::array<double, 3>& k, double part) {
      return std::array<double, 3>{x + part * k[0], v + part * k[1], f + part * k[2]};
    };
    const auto k1 = rates(time_s, s, mass, oil);
    const auto k2 = rates(time_s, at(k1, 0.5 * h), mass, oil);
    const auto k3 = rates(time_s, at(k2, 0.5 * h), mass, oil);
    const auto k4 = rates(time_s, at(k3, h), mass, oil);
    const auto over = [&](std::size_t i) { return h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]); };
    x += over(0);
    v += over(1);
    f += over(2);
  }
};

TEST(WavyFriction, FollowsAnIndependentIntegration) {
  constexpr double kOil_N_m = 160.0;
  constexpr double kStep_s = 2e-6;
  const ActuatorParams actuator = thin_cylinder();
  HydraulicJoint joint =
      HydraulicJoint::create(actuator, sprung_load(), equilibrium(actuator, sprung_load(), kMiddle_m, 0.0), 1e-8,
                             std::array{wave()})
          .value();
  const double mass = joint.load().mass + actuator.piston_mass;
  Independent other;
  double most_m = 0.0;
  for (int tick = 0; tick < 300; ++tick) {
    joint.step(0.0, push(kPeriod_s * tick), kPeriod_s);
    for (int part = 0; part < 500; ++part) {
      other.step(kPeriod_s * tick, kStep_s, mass, kOil_N_m);  // the push is held over a tick
    }
    // The oil's spring is not quite straight.
    most_m = std::max(most_m, std::abs(other.x - kMiddle_m));
    ASSERT_NEAR(joint.state().position, other.x, 5e-3 * kWavelength_m) << "tick " << tick;
    ASSERT_NEAR(joint.effects().friction, other.f, 0.03 * kCoulomb_N) << "tick " << tick;
  }
  EXPECT_GT(most_m, kWavelength_m) << "the load crosses whole waves";
}

// In steady sliding the friction is the level of the place.
TEST(WavyFriction, IsTightAndLooseByItsPlace) {
  const WavyFriction friction({kCoulomb_N, kRatio * kCoulomb_N, kStribeck_m_s, kPresliding_m},
                              {kWaviness, kWavelength_m, kTightest_m}, 2500.0, 0.3, 1e-6);
  const auto rate = [&](double force, double position) {
    Instant now{};
    now.velocity = 0.1;
    now.position = position;
    Friction::X dx{};
    friction.after_valve(now, {force}, dx);
    EXPECT_EQ(now.load_force, -force);
    return dx[0];
  };
  for (const double at : {kTightest_m, kTightest_m - kWavelength_m}) {
    EXPECT_NEAR(rate(1.6 * kCoulomb_N, at), 0.0, 1.0);
  }
  EXPECT_NEAR(rate(0.4 * kCoulomb_N, kTightest_m + 0.5 * kWavelength_m), 0.0, 1.0);
  EXPECT_NEAR(rate(kCoulomb_N, kTightest_m + 0.25 * kWavelength_m), 0.0, 1.0);
}

TEST(WavyFriction, ActsBesideALevelOne) {
  const ActuatorParams actuator = thin_cylinder();
  const LoadParams load = sprung_load();
  const auto held = [&](const std::vector<ActiveEffect>& effects) {
    HydraulicJoint joint = test::joint_with(actuator, load, effects);
    for (int tick = 0; tick < 400; ++tick) {
      joint.step(0.0, 0.2 * tick, kPeriod_s);
    }
    return joint.effects().friction;
  };
  const double level = held({effect_of("load_friction", {20.0}, actuator, load)});
  const double both = held({effect_of("load_friction", {20.0}, actuator, load), wave()});
  EXPECT_GT(both, level + 0.3 * kCoulomb_N);
}

TEST(WavyFriction, WithoutAPlaceToSlideIsRefused) {
  const ActuatorParams actuator = thin_cylinder();
  const auto joint = HydraulicJoint::create(
      actuator, sprung_load(), equilibrium(actuator, sprung_load(), kMiddle_m, 0.0), 1e-6, std::array{wave(1.0)});
  ASSERT_FALSE(joint.ok());
  EXPECT_NE(joint.error().message.find("position_dependent_friction: waviness"), std::string::npos)
      << joint.error().message;
}

TEST(GeneralForms, BeginWithTheParametersOfTheirSpecialCases) {
  std::size_t general = 0;
  for (EffectId id = 0; id < kNameableCount; ++id) {
    if (!is_general_form(id)) {
      continue;
    }
    ++general;
    const EffectId special = special_case_of(id);
    ASSERT_LT(special, kNameableCount) << effect_info(id).name;
    EXPECT_EQ(general_form_of(special), id);
    EXPECT_EQ(effect_info(special).side, effect_info(id).side);
    for (std::size_t i = 0; i < effect_info(special).parameters.size(); ++i) {
      EXPECT_STREQ(effect_info(special).parameters[i].name, effect_info(id).parameters[i].name);
    }
  }
  EXPECT_GE(general, 1u);
  EXPECT_EQ(general_form_of(find_effect("load_mass")), kNameableCount);
}

}  // namespace wavy_friction_test
}  // namespace farrier::plant
