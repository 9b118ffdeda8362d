#include "sim_bridge/sensor_chain.hpp"

#include <cmath>
#include <numbers>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::sim_bridge {
namespace sensor_chain_test {

using namespace testing;

robot::Robot rig() { return robot::load_shipped("fc1d"); }

SensorChain chain_of(const robot::Joint& joint) { return SensorChain::create(joint, 0.001, 7).value(); }

TEST(SensorChain, WithoutAnythingInItIsTheTruthWithTheTicksNoise) {
  const robot::Robot robot = rig();
  const robot::Joint& joint = robot.joints[0];
  const NoiseStream position(7, joint.name, "position"), velocity(7, joint.name, "velocity"),
      force(7, joint.name, "force");
  SensorChain chain = chain_of(joint);
  chain.begin({0.04, 0.0, 12.0});
  for (Tick tick = 0; tick < 100; ++tick) {
    const Measured truth{0.04 + 1e-4 * static_cast<double>(tick), 0.1, 12.0};
    chain.convert(truth, tick, 0);
    EXPECT_EQ(chain.sample().position, truth.position + joint.noise.position * position.normal(tick));
    EXPECT_EQ(chain.sample().velocity, truth.velocity + joint.noise.velocity * velocity.normal(tick));
    EXPECT_EQ(chain.sample().force, truth.force + joint.noise.force * force.normal(tick));
  }
}

TEST(SensorChain, AveragesItsConversionsSoThatNoiseFallsWithTheirRoot) {
  robot::Robot robot = rig();
  robot::Joint& joint = robot.joints[0];
  joint.sensors.oversampling = 16;
  SensorChain chain = chain_of(joint);
  chain.begin({});
  constexpr int kTicks = 4000;
  double square = 0.0;
  for (Tick tick = 1; tick <= kTicks; ++tick) {
    for (int i = 0; i < 16; ++i) {
      chain.convert({}, tick, i);
    }
    square += std::pow(chain.sample().force, 2);
  }
  const double expected = joint.noise.force / 4.0;
  EXPECT_NEAR(square / kTicks / (expected * expected), 1.0, 5.0 * std::sqrt(2.0 / kTicks));  // five sigma
}

// A tone of 900 Hz, sampled at 1 kHz, looks like one of 100 Hz: aliasing. Conversions at 16 kHz behind an analog low-pass
// of 200 Hz take it out before the tick sees it.
TEST(SensorChain, KeepsTonesAboveHalfTheRateOutWhereItConvertsFaster) {
  robot::Robot robot = rig();
  robot::Joint& joint = robot.joints[0];
  joint.noise = {};
  const auto largest = [&joint] {
    SensorChain chain = chain_of(joint);
    const int conversions = joint.sensors.oversampling;
    double most = 0.0;
    for (Tick tick = 0; tick < 500; ++tick) {
      for (int i = 0; i < conversions; ++i) {
        const double t = (static_cast<double>(tick) + static_cast<double>(i + 1) / conversions) * 1e-3;
        chain.convert({0.0, std::sin(2.0 * std::numbers::pi * 900.0 * t), 0.0}, tick, i);
      }
      most = tick > 100 ? std::max(most, std::abs(chain.sample().velocity)) : 0.0;
    }
    return most;
  };
  EXPECT_GT(largest(), 0.9);
  joint.sensors.oversampling = 16;
  joint.sensors.anti_alias.cut_off_Hz = 200.0;
  // (200 / 900)^2 = 0.049 by the low-pass, and the mean over a tick passes sinc(0.9) = 0.11 of it.
  EXPECT_LT(largest(), 1.2 * 0.049 * 0.11);
}

TEST(SensorChain, ReadsPositionsInStepsOfItsResolution) {
  robot::Robot robot = rig();
  robot::Joint& joint = robot.joints[0];
  joint.noise = {};
  joint.sensors.position_step = 0x1p-14;
  SensorChain chain = chain_of(joint);
  for (Tick tick = 0; tick < 200; ++tick) {
    const double truth = 1.7e-6 * static_cast<double>(tick);
    chain.convert({truth, truth, truth}, tick, 0);
    EXPECT_EQ(std::fmod(chain.sample().position, 0x1p-14), 0.0);
    EXPECT_LE(std::abs(chain.sample().position - truth), 0x1p-15);
    EXPECT_EQ(chain.sample().velocity, truth);
  }
}

TEST(SensorChain, FiltersTheChannelItIsAskedToAndNoOther) {
  robot::Robot robot = rig();
  robot::Joint& joint = robot.joints[0];
  joint.noise = {};
  joint.sensors.velocity = {100.0, 2, 0.7071};
  control::LowPass second_route(control::design_low_pass(joint.sensors.velocity, 1000.0).value());
  SensorChain chain = chain_of(joint);
  chain.begin({});
  second_route.take(0.0);
  for (Tick tick = 1; tick < 50; ++tick) {
    chain.convert({0.5, 0.5, 0.5}, tick, 0);
    EXPECT_EQ(chain.sample().position, 0.5);
    EXPECT_EQ(chain.sample().velocity, second_route.take(0.5));
    EXPECT_EQ(chain.sample().force, 0.5);
  }
}

TEST(SensorChain, RefusesFiltersItsRateDoesNotCarry) {
  robot::Robot robot = rig();
  robot.joints[0].sensors.velocity.cut_off_Hz = 480.0;
  const auto refused = SimWorld::create(robot, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("0.45 of its sampling rate"), std::string::npos) << refused.error().message;
  robot.joints[0].sensors.velocity.cut_off_Hz = 0.0;
  robot.joints[0].sensors.oversampling = 0;
  EXPECT_FALSE(SimWorld::create(robot, 1));
}

TEST(SimWorld, WithFilteringSensorsIsTheSameForTheSameSeedAndDoesNotAllocate) {
  robot::Robot robot = rig();
  robot.joints[0].sensors = {.position = {},
                             .velocity = {100.0, 2, 0.7071},
                             .force = {200.0, 1, 0.7071},
                             .anti_alias = {1000.0, 2, 0.7071},
                             .oversampling = 4,
                             .position_step = 1e-6};
  SimWorld one = world_of(robot, 3);
  SimWorld other = world_of(robot, 3);
  const std::vector<double> open{1e-3};
  const test::AllocationGuard guard;
  for (int i = 0; i < 300; ++i) {
    one.advance(open);
    other.advance(open);
    ASSERT_EQ(one.sample(0).velocity_m_s_or_rad_s, other.sample(0).velocity_m_s_or_rad_s);
    ASSERT_EQ(one.sample(0).force_N_or_Nm, other.sample(0).force_N_or_Nm);
    other.sample(0);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

// A period in eight parts is the same period: the joint's motion agrees within what the integrator states.
TEST(SimWorld, MovesTheSameHoweverOftenItsSensorsConvert) {
  robot::Robot often = rig();
  often.joints[0].sensors.oversampling = 8;
  SimWorld one = world_of(rig());
  SimWorld other = world_of(often);
  for (int i = 0; i < 200; ++i) {
    one.advance(std::vector{i < 100 ? 1e-3 : -1e-3});
    other.advance(std::vector{i < 100 ? 1e-3 : -1e-3});
  }
  // 1e-6 of the stroke per substep and no feedback: up to a few substeps a tick, 200 ticks.
  EXPECT_NEAR(row_of(one, 0).position_m_or_rad, row_of(other, 0).position_m_or_rad, 200 * 10 * 1e-6 * 0.08);
  EXPECT_GT(std::abs(row_of(one, 0).position_m_or_rad - 0.04), 1e-4);
}

}  // namespace sensor_chain_test
}  // namespace farrier::sim_bridge
