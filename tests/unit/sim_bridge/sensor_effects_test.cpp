#include <cmath>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::sim_bridge {
namespace sensor_effects_test {

using namespace testing;

robot::Robot rig_with(const std::string& effects) {
  const std::string text = robot::text_of("fc1d") + "\neffects:\n  fc1d:\n" + effects;
  const auto robot = robot::load_robot_text(text, "fc1d.yaml");
  EXPECT_TRUE(robot.ok()) << (robot ? "" : to_string(robot.error()));
  return robot ? robot.value() : robot::Robot{};
}

robot::Robot quiet(robot::Robot robot) {
  robot.joints[0].noise = {};
  return robot;
}

SensorChain chain_of(const robot::Robot& robot) {
  return SensorChain::create(robot.joints[0], robot.period_s, 7).value();
}

TEST(SensorEffects, OfTheLoadCellAreLagThenGainThenOffset) {
  constexpr double kLag_s = 0.004;
  SensorChain chain =
      chain_of(quiet(rig_with("    force_sensor_offset: {offset_N: 40}\n"
                              "    force_sensor_gain: {gain: 1.5}\n"
                              "    force_sensor_lag: {time_constant_s: 0.004}\n")));
  chain.begin({0.04, 0.0, 100.0});
  EXPECT_NEAR(chain.sample().force, 1.5 * 100.0 + 40.0, 1e-12) << "it has stood there forever";
  // tau y' + y = x for a force that rises by 10 N a tick: y = x - r tau (1 - exp(-t / tau)), r in N/s.
  for (Tick tick = 1; tick <= 50; ++tick) {
    const double t = 0.001 * static_cast<double>(tick);
    const double force = 100.0 + 1e4 * t;
    chain.convert({0.04, 0.3, force}, tick, 0);
    const double lagged = force - 1e4 * kLag_s * (1.0 - std::exp(-t / kLag_s));
    EXPECT_NEAR(chain.sample().force, 1.5 * lagged + 40.0, 1e-9) << tick;
    EXPECT_EQ(chain.sample().velocity, 0.3);
    EXPECT_EQ(chain.sample().position, 0.04);
  }
}

TEST(SensorEffects, ComeBeforeTheNoise) {
  const robot::Robot robot = rig_with("    force_sensor_gain: {gain: 2}\n");
  const robot::Joint& joint = robot.joints[0];
  const NoiseStream noise(7, joint.name, "force");
  SensorChain chain = chain_of(robot);
  chain.begin({0.04, 0.0, 100.0});
  for (Tick tick = 1; tick < 20; ++tick) {
    chain.convert({0.04, 0.0, 100.0}, tick, 0);
    EXPECT_EQ(chain.sample().force, 200.0 + joint.noise.force * noise.normal(tick));
  }
}

// A lag is one of time: however often the tick is converted.
TEST(SensorEffects, KeepTheirTimeConstantWithOversampling) {
  robot::Robot robot = quiet(rig_with("    velocity_filter_lag: {time_constant_s: 0.01}\n"));
  for (const int conversions : {1, 8}) {
    robot.joints[0].sensors.oversampling = conversions;
    SensorChain chain = chain_of(robot);
    chain.begin({});
    for (Tick tick = 1; tick <= 30; ++tick) {
      for (int i = 0; i < conversions; ++i) {
        const double t = 0.001 * (static_cast<double>(tick - 1) + (i + 1.0) / conversions);
        chain.convert({0.0, t, t}, tick, i);
      }
    }
    // Mean over the last tick's conversions of t - tau (1 - exp(-t / tau)), t about 30 ms less half a tick.
    const double t = 0.030 - 0.0005 * (conversions - 1) / conversions;
    EXPECT_NEAR(chain.sample().velocity, t - 0.01 * (1.0 - std::exp(-t / 0.01)), 1e-5) << conversions;
    EXPECT_NEAR(chain.sample().force, t, 1e-12);
  }
}

TEST(SensorEffects, ChangeSamplesAndNotTheTruth) {
  SimWorld with = world_of(rig_with("    force_sensor_offset: {offset_N: 25}\n"));
  SimWorld without = world_of(robot::load_shipped("fc1d"));
  for (int i = 0; i < 100; ++i) {
    with.advance(std::vector{1e-3});
    without.advance(std::vector{1e-3});
    ASSERT_TRUE(same_state(row_of(with, 0), row_of(without, 0)));
    ASSERT_NEAR(with.sample(0).force_N_or_Nm - without.sample(0).force_N_or_Nm, 25.0, 1e-9);
    ASSERT_EQ(with.sample(0).velocity_m_s_or_rad_s, without.sample(0).velocity_m_s_or_rad_s);
  }
}

TEST(SimWorld, HasTheEffectsOfItsRobotAndDoesNotAllocate) {
  const robot::Robot robot = rig_with(
      "    input_delay: {delay_s: 0.0023}\n    load_friction: {coulomb_N: 60}\n"
      "    piston_friction: {coulomb_N: 30}\n    backlash: {play_m: 2e-4}\n    supply_droop: "
      "{resistance_Pa_s_m3: 2e10}\n    air_entrainment: {air_fraction: 0.02}\n");
  SimWorld one = world_of(robot, 3);
  SimWorld other = world_of(robot, 3);
  SimWorld nominal = world_of(robot::load_shipped("fc1d"), 3);
  const std::vector<double> open{2e-3};
  const test::AllocationGuard guard;
  for (int i = 0; i < 300; ++i) {
    one.advance(open);
    other.advance(open);
    nominal.advance(open);
    ASSERT_EQ(one.sample(0).force_N_or_Nm, other.sample(0).force_N_or_Nm);
  }
  EXPECT_EQ(guard.allocations(), 0u);
  expect_finite(row_of(one, 0));
  EXPECT_FALSE(same_state(row_of(one, 0), row_of(nominal, 0)));
}

TEST(SimWorld, RefusesEffectsThatNoJointCarriesByItsName) {
  robot::Robot robot = robot::load_shipped("fc1d");
  robot.joints[0].effects.push_back({plant::find_effect("valve_bias"), {std::nan("")}});
  const auto refused = SimWorld::create(robot, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("valve_bias: current_A"), std::string::npos) << refused.error().message;
}

}  // namespace sensor_effects_test
}  // namespace farrier::sim_bridge
