#include <algorithm>
#include <limits>
#include <random>

#include "tests/support/allocation_guard.hpp"
#include "tests/unit/sim_bridge/sim_world_bench.hpp"

namespace farrier::sim_bridge {
namespace sim_world_test {

using namespace testing;

const robot::Robot& hyq() {
  static const robot::Robot robot = robot::load_shipped("hyq", {.without_effects = true});
  return robot;
}

void randomise(std::vector<double>& currents, std::mt19937_64& random, double largest_A) {
  std::uniform_real_distribution<double> current(-largest_A, largest_A);
  for (double& value : currents) {
    value = current(random);
  }
}

TEST(SimWorld, StartsAtRestInTheHomePose) {
  const SimWorld world = world_of(hyq());
  EXPECT_EQ(world.tick(), 0);
  ASSERT_EQ(world.joints(), hyq().joints.size());
  for (std::size_t i = 0; i < world.joints(); ++i) {
    const auto row = row_of(world, i);
    const robot::Joint& joint = hyq().joints[i];
    EXPECT_EQ(row.position_m_or_rad, joint.linkage.position(joint.home_angle_rad)) << joint.name;
    EXPECT_EQ(row.velocity_m_s_or_rad_s, 0.0);
    EXPECT_EQ(row.load_mass_kg_or_kgm2, joint.stance_load.mass);
  }
}

TEST(SimWorld, IsAWorldWithTheReadingsOfItsSamples) {
  SimWorld bench = world_of(hyq());
  world::World& world = bench;
  EXPECT_TRUE(world.advance(shut(bench)));
  EXPECT_EQ(world.tick(), 1);
  for (std::size_t joint = 0; joint < world.joints(); ++joint) {
    const signals::JointSensors sample = bench.sample(joint);
    const world::JointReading reading = world.reading(joint);
    EXPECT_EQ(reading.position, sample.position_m_or_rad);
    EXPECT_EQ(reading.velocity, sample.velocity_m_s_or_rad_s);
    EXPECT_EQ(reading.force, sample.force_N_or_Nm);
  }
  EXPECT_FALSE(world.imu().has_value());
  EXPECT_FALSE(world.failure().has_value());
}

TEST(SimWorld, GivesTheSameNumbersForTheSameSeed) {
  SimWorld one = world_of(hyq(), 5);
  SimWorld other = world_of(hyq(), 5);
  std::mt19937_64 random(1);
  std::vector<double> currents = shut(one);
  for (int i = 0; i < 300; ++i) {
    for (std::size_t joint = 0; joint < one.joints(); ++joint) {
      const auto a = one.sample(joint);
      const auto b = other.sample(joint);
      ASSERT_EQ(a.position_m_or_rad, b.position_m_or_rad);
      ASSERT_EQ(a.velocity_m_s_or_rad_s, b.velocity_m_s_or_rad_s);
      ASSERT_EQ(a.force_N_or_Nm, b.force_N_or_Nm);
    }
    randomise(currents, random, 0.01);
    one.advance(currents);
    other.advance(currents);
  }
}

TEST(SimWorld, GivesOtherNoiseButTheSameWorldForAnotherSeed) {
  robot::Robot punctual = hyq();
  punctual.plan.gait.touchdown_jitter_s = 0.0;  // the one thing in the world that a seed decides
  SimWorld one = world_of(punctual, 5);
  SimWorld other = world_of(punctual, 6);
  for (int i = 0; i < 50; ++i) {
    for (std::size_t joint = 0; joint < one.joints(); ++joint) {
      EXPECT_NE(one.sample(joint).force_N_or_Nm, other.sample(joint).force_N_or_Nm);
      EXPECT_TRUE(same_state(row_of(one, joint), row_of(other, joint)));
    }
    one.advance(shut(one));
    other.advance(shut(other));
  }
}

TEST(SimWorld, AddsTheNoiseOfTheRobotFileToTheTruth) {
  SimWorld world = world_of(hyq());
  constexpr int kTicks = 400;
  const auto samples = static_cast<double>(kTicks) * static_cast<double>(world.joints());
  double position = 0, velocity = 0, force = 0;
  for (int i = 0; i < kTicks; ++i) {
    for (std::size_t joint = 0; joint < world.joints(); ++joint) {
      const auto truth = row_of(world, joint);
      const auto sample = world.sample(joint);
      const robot::SensorNoise& noise = hyq().joints[joint].noise;
      position += std::pow((sample.position_m_or_rad - truth.position_m_or_rad) / noise.position, 2);
      velocity += std::pow((sample.velocity_m_s_or_rad_s - truth.velocity_m_s_or_rad_s) / noise.velocity, 2);
      force += std::pow((sample.force_N_or_Nm - truth.force_N_or_Nm) / noise.force, 2);
    }
    world.advance(shut(world));
  }
  const double bound = 5.0 * std::sqrt(2.0 / samples);  // five sigma: the variance of a normal's square is 2
  EXPECT_NEAR(position / samples, 1.0, bound);
  EXPECT_NEAR(velocity / samples, 1.0, bound);
  EXPECT_NEAR(force / samples, 1.0, bound);
}

TEST(SimWorld, IsNotDisturbedByBeingLookedAt) {
  SimWorld watched = world_of(hyq());
  SimWorld alone = world_of(hyq());
  for (int i = 0; i < 20; ++i) {
    for (int look = 0; look < 3; ++look) {
      EXPECT_EQ(watched.sample(4).force_N_or_Nm, watched.sample(4).force_N_or_Nm);
    }
    watched.advance(shut(watched));
    alone.advance(shut(alone));
  }
  EXPECT_TRUE(same_state(row_of(watched, 4), row_of(alone, 4)));
}

// The cart's springs are slack at home, so the shut rig is in equilibrium. It moves by the rounding of pressures of
// 1e7 Pa (2e-9 Pa) that act on 2e-4 m^2. This is 4e-13 N against more than 1e6 N/m, over and over.
TEST(SimWorld, DoesNotMoveWithAShutValveAndNoForce) {
  robot::Robot rig = robot::load_shipped("fc1d");
  SimWorld world = world_of(rig);
  const double start = row_of(world, 0).position_m_or_rad;
  for (int i = 0; i < 1000; ++i) {
    world.advance(shut(world));
  }
  EXPECT_NEAR(row_of(world, 0).position_m_or_rad, start, 1e-12);
}

// A shut valve leaves the oil in: under the robot's weight a standing leg gives as much as the oil is compressed.
TEST(SimWorld, CarriesTheRobotOnShutValves) {
  const robot::Robot standing = robot::load_shipped(
      "hyq", {.pattern = gait::Pattern::kStand, .frequency_Hz = std::nullopt, .without_effects = true});
  SimWorld world = world_of(standing);
  std::vector<double> start, largest_force(world.joints(), 0.0), largest_way(world.joints(), 0.0);
  for (std::size_t i = 0; i < world.joints(); ++i) {
    start.push_back(row_of(world, i).position_m_or_rad);
  }
  for (int tick = 0; tick < 1500; ++tick) {
    for (std::size_t i = 0; i < world.joints(); ++i) {
      const auto row = row_of(world, i);
      largest_force[i] = std::max(largest_force[i], std::abs(row.external_force_N_or_Nm));
      largest_way[i] = std::max(largest_way[i], std::abs(row.position_m_or_rad - start[i]));
    }
    world.advance(shut(world));
  }
  for (std::size_t i = 0; i < world.joints(); ++i) {
    const plant::ActuatorParams& a = standing.joints[i].actuator;
    const double volume_a = a.line_volume_m3 + a.area_a * start[i];
    const double volume_b = a.line_volume_m3 + a.area_b * (a.stroke - start[i]);
    // Stiffness of two closed chambers, Merritt (1967); a load put on at once would swing to twice its deflection.
    const double stiffness = a.bulk_modulus_Pa * (a.area_a * a.area_a / volume_a + a.area_b * a.area_b / volume_b);
    EXPECT_LE(largest_way[i], 2.0 * largest_force[i] / stiffness) << standing.joints[i].name;
    EXPECT_GT(largest_force[i], 0.0) << standing.joints[i].name << " carries nothing";
  }
}

TEST(SimWorld, StaysFiniteUnderRandomValveCurrents) {
  SimWorld world = world_of(hyq());
  std::mt19937_64 random(8);
  std::vector<double> currents = shut(world);
  for (int i = 0; i < 1500; ++i) {
    randomise(currents, random, 0.03);
    world.advance(currents);
    for (std::size_t joint = 0; joint < world.joints(); ++joint) {
      expect_finite(row_of(world, joint));
    }
  }
}

TEST(SimWorld, StaysFiniteWhenValveCurrentsAreNotFinite) {
  SimWorld world = world_of(hyq());
  using Limits = std::numeric_limits<double>;
  for (const double current : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max()}) {
    for (int i = 0; i < 50; ++i) {
      world.advance(std::vector<double>(world.joints(), current));
    }
    for (std::size_t joint = 0; joint < world.joints(); ++joint) {
      expect_finite(row_of(world, joint));
    }
  }
}

TEST(SimWorld, RefusesAJointThatCannotBeSimulatedByName) {
  robot::Robot broken = hyq();
  broken.joints[5].actuator.bulk_modulus_Pa = -1;
  const auto refused = SimWorld::create(broken, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message.find(broken.joints[5].name + ": "), 0u) << refused.error().message;
}

TEST(SimWorld, AdvanceDoesNotAllocate) {
  SimWorld world = world_of(hyq());
  const std::vector<double> currents = shut(world);
  trace::TraceRow row;
  const test::AllocationGuard guard;
  for (int i = 0; i < 900; ++i) {  // into the first swing
    world.advance(currents);
    world.sample(0);
    world.describe(0, row);
  }
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace sim_world_test
}  // namespace farrier::sim_bridge
