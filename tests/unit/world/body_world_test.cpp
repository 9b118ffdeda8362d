#include "world/body_world.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/allocation_guard.hpp"

namespace farrier::world {
namespace body_world_test {

robot::Robot load(const std::string& name) { return robot::load_robot(FARRIER_ROBOTS + name + ".yaml").value(); }

const robot::Robot& hyq() {
  static const robot::Robot robot = load("hyq");
  return robot;
}

// Holds the home pose from readings alone: impedance at each joint, and the torques J' f of an even share of the weight.
class Stance {
 public:
  explicit Stance(const BodyWorld& world, const robot::Robot& robot = hyq()) : robot_(robot) {
    const double force_N = world.body().total_mass_kg() * robot.body->gravity_m_s2 / world.body().legs();
    for (int leg = 0; leg < world.body().legs(); ++leg) {
      const Eigen::Matrix3d jacobian =
          world.body().foot_jacobian(leg).middleCols<3>(body::kTrunkVelocities + body::kJointsPerLeg * leg);
      const Eigen::Vector3d torques_Nm = -force_N * jacobian.row(2).transpose();
      feed_forward_Nm_.insert(feed_forward_Nm_.end(), torques_Nm.begin(), torques_Nm.end());
    }
    torques_Nm_.resize(feed_forward_Nm_.size());
  }

  std::span<const double> step(const World& world) {
    for (std::size_t joint = 0; joint < world.joints(); ++joint) {
      const JointReading reading = world.reading(joint);
      torques_Nm_[joint] = feed_forward_Nm_[joint] + 1500.0 * (robot_.joints[joint].home_angle_rad - reading.position) -
                           40.0 * reading.velocity;
    }
    return torques_Nm_;
  }

 private:
  const robot::Robot& robot_;
  std::vector<double> feed_forward_Nm_;
  std::vector<double> torques_Nm_;
};

BodyWorld world_of(const body::Scene& scene = {}, std::uint64_t seed = 1, const BodyNoise& noise = {}) {
  auto world = BodyWorld::create(hyq(), scene, seed, noise);
  EXPECT_TRUE(world.ok()) << (world ? "" : world.error().message);
  return std::move(world).value();
}

constexpr BodyNoise kNoise{1e-4, 1e-2, 1.0, 2e-3, 5e-3, 0.05};

TEST(BodyWorld, StartsAtRestOnItsFeet) {
  const BodyWorld world = world_of();
  EXPECT_EQ(world.tick(), 0);
  EXPECT_EQ(world.joints(), 12u);
  for (int leg = 0; leg < 4; ++leg) {
    EXPECT_NEAR(world.body().foot_position_m(leg).z(), 0.02175, 1e-12);
  }
  EXPECT_EQ(world.imu()->rate_rad_s, Eigen::Vector3d::Zero());
  EXPECT_NEAR(world.imu()->specific_force_m_s2.z(), 9.81, 1e-12);
}

TEST(BodyWorld, StandsForFiveSecondsOnNoisyReadings) {
  BodyWorld world = world_of({}, 1, kNoise);
  Stance stance(world);
  const double height_m = world.state().position_m.z();
  for (int tick = 0; tick < 5000; ++tick) {
    ASSERT_TRUE(world.advance(stance.step(world))) << *world.failure();
  }
  EXPECT_EQ(world.tick(), 5000);
  EXPECT_NEAR(world.state().position_m.z(), height_m, 0.01);
  EXPECT_LT(world.state().attitude.vec().norm(), 0.01);
  double sum_N = 0.0;
  for (int leg = 0; leg < 4; ++leg) {
    sum_N += world.foot_force_N(leg).z();
  }
  EXPECT_NEAR(sum_N, 84.756 * 9.81, 0.1 * sum_N) << "one tick, with the noise of velocities";
}

TEST(BodyWorld, StandsOnSixLegs) {
  const robot::Robot hexapod = load("hexapod");
  BodyWorld world = BodyWorld::create(hexapod, {}, 1).value();
  Stance stance(world, hexapod);
  for (int tick = 0; tick < 2000; ++tick) {
    ASSERT_TRUE(world.advance(stance.step(world))) << *world.failure();
  }
  EXPECT_LT(world.state().attitude.vec().norm(), 0.01);
  double sum_N = 0.0;
  for (int leg = 0; leg < 6; ++leg) {
    EXPECT_GT(world.foot_force_N(leg).z(), 50.0) << leg;
    sum_N += world.foot_force_N(leg).z();
  }
  EXPECT_NEAR(sum_N, 127.134 * 9.81, 0.01 * sum_N);
}

TEST(BodyWorld, FeelsNoForceWhileItFalls) {
  body::Scene scene;
  scene.friction = 0.0;
  BodyWorld world = world_of(scene);
  std::vector<double> limp(world.joints(), 0.0);
  // Legs give way without torques; the trunk's acceleration is near that of gravity within the first ticks.
  for (int tick = 0; tick < 20; ++tick) {
    ASSERT_TRUE(world.advance(limp));
  }
  EXPECT_LT(world.imu()->specific_force_m_s2.norm(), 2.0);
}

TEST(BodyWorld, GivesTheSameNumbersForTheSameSeed) {
  BodyWorld one = world_of({}, 3, kNoise);
  BodyWorld other = world_of({}, 3, kNoise);
  Stance stance(one);
  for (int tick = 0; tick < 200; ++tick) {
    one.advance(stance.step(one));
    other.advance(stance.step(other));
  }
  EXPECT_EQ(one.state().velocity(), other.state().velocity());
  EXPECT_EQ(one.imu()->attitude.coeffs(), other.imu()->attitude.coeffs());
  EXPECT_NE(world_of({}, 4, kNoise).reading(0).position, world_of({}, 3, kNoise).reading(0).position);
}

TEST(BodyWorld, PutsThePayloadOnTheTrunkAtItsTime) {
  body::Scene scene;
  scene.payloads.push_back({"load", 1.0, 20.0, {0.0, 0.0, 0.15}});
  BodyWorld world = world_of(scene);
  Stance stance(world);
  const auto sum_N = [&world] {
    double sum = 0.0;
    for (int leg = 0; leg < 4; ++leg) {
      sum += world.foot_force_N(leg).z();
    }
    return sum;
  };
  for (int tick = 0; tick < 1000; ++tick) {
    world.advance(stance.step(world));
  }
  EXPECT_NEAR(sum_N(), 84.756 * 9.81, 0.01 * sum_N());
  for (int tick = 0; tick < 2000; ++tick) {
    world.advance(stance.step(world));
  }
  EXPECT_NEAR(sum_N(), 104.756 * 9.81, 0.01 * sum_N());
}

TEST(BodyWorld, FailsWithTheTickOfAnImpossibleTorque) {
  BodyWorld world = world_of();
  std::vector<double> torques(world.joints(), 0.0);
  ASSERT_TRUE(world.advance(torques));
  torques[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(world.advance(torques));
  EXPECT_EQ(world.failure(), "the body cannot be simulated beyond tick 1: an acceleration is not finite or huge");
  torques[2] = 0.0;
  EXPECT_FALSE(world.advance(torques)) << "a failure is final";
  EXPECT_TRUE(std::isfinite(world.reading(2).position));
}

TEST(BodyWorld, RefusesAFootInABox) {
  body::Scene scene;
  body::Box box;
  box.name = "table";
  box.centre_m = {0.37, 0.32, 0.1};
  box.half_extents_m = {0.3, 0.3, 0.1};
  scene.boxes.push_back(box);
  const auto world = BodyWorld::create(hyq(), scene, 1);
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(world.error().message, "the foot of leg lf starts in box table: move the box or start higher");
}

TEST(BodyWorld, RefusesARobotWithoutTrunk) {
  const auto world = BodyWorld::create(load("electric_leg"), {}, 1);
  ASSERT_FALSE(world.ok());
  EXPECT_EQ(
      world.error().message,
      "electric_leg is not described as rigid bodies: give body.trunk, body.foot_radius_m and the hip_position_m of "
      "each leg in its file");
}

TEST(BodyWorld, AllocatesNothingInATick) {
  body::Scene scene;
  scene.payloads.push_back({"load", 0.001, 20.0, {0.0, 0.0, 0.15}});
  BodyWorld world = world_of(scene, 1, kNoise);
  Stance stance(world);
  world.advance(stance.step(world));
  const test::AllocationGuard guard;
  world.advance(stance.step(world));
  world.imu();
  EXPECT_EQ(guard.allocations(), 0u);
}

}  // namespace body_world_test
}  // namespace farrier::world
