#include "trials/body/body_trial.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "trials/body/stand.hpp"
#include "world/scene_file.hpp"

namespace farrier::trials {
namespace body_trial_test {

robot::Robot load(const std::string& name) { return robot::load_robot(FARRIER_ROBOTS + name + ".yaml").value(); }

class Constant final : public BodyController {
 public:
  explicit Constant(double torque_Nm) : torque_Nm_(torque_Nm) {}
  void step(const world::World&, std::span<double> torques_Nm) noexcept override {
    std::ranges::fill(torques_Nm, torque_Nm_);
  }

 private:
  double torque_Nm_;
};

class BodyTrial : public testing::Test {
 protected:
  const robot::Robot hyq_ = load("hyq");
  world::BodyWorld world_ = world::BodyWorld::create(hyq_, {}, 1).value();
};

TEST_F(BodyTrial, ReportsARobotThatStands) {
  Stand stand = Stand::create(hyq_).value();
  const BodyFigures figures = run_body_trial(world_, stand, 2000);
  EXPECT_TRUE(figures.passes());
  EXPECT_EQ(figures.ticks, 2000);
  EXPECT_LT(figures.height_rms_m, 0.01);
  EXPECT_LT(figures.tilt_rms_rad, 0.01);
  EXPECT_LT(figures.travel_m.norm(), 0.01);
  EXPECT_GT(figures.largest_foot_force_N, 200.0);
  // A bent knee carries a quarter of 84.756 kg over 0.24 m.
  EXPECT_NEAR(figures.largest_torque_Nm[2], 49.0, 15.0);
}

TEST_F(BodyTrial, EndsWhenALimpRobotFalls) {
  Constant limp(0.0);
  const BodyFigures figures = run_body_trial(world_, limp, 5000);
  EXPECT_FALSE(figures.passes());
  ASSERT_TRUE(figures.fell.has_value());
  EXPECT_EQ(*figures.fell, figures.ticks);
  EXPECT_EQ(figures.fall, FallReason::kHeight);
  EXPECT_LT(figures.ticks, 1000);
  EXPECT_GT(figures.ticks, 100) << "a free fall of half the height takes 0.25 s";
}

TEST_F(BodyTrial, ReportsTheFailureOfTheSimulation) {
  Constant broken(std::numeric_limits<double>::quiet_NaN());
  const BodyFigures figures = run_body_trial(world_, broken, 5000);
  EXPECT_FALSE(figures.passes());
  EXPECT_EQ(figures.ticks, 0);
  EXPECT_EQ(figures.failure, "the body cannot be simulated beyond tick 0: an acceleration is not finite or huge");
}

TEST_F(BodyTrial, StandsThroughThePushAndThePayloadOfAShippedScene) {
  const body::Scene scene = world::load_scene(FARRIER_SCENES "disturbed.yaml").value();
  world::BodyWorld world = world::BodyWorld::create(hyq_, scene, 1).value();
  Stand stand = Stand::create(hyq_).value();
  const BodyFigures figures = run_body_trial(world, stand, 12000);
  EXPECT_TRUE(figures.passes()) << figures.fell.value_or(-1);
}

TEST_F(BodyTrial, RefusesARobotWithoutTrunk) {
  const auto stand = Stand::create(load("fc1d"));
  ASSERT_FALSE(stand.ok());
  EXPECT_EQ(stand.error().message.substr(0, 4), "fc1d");
}

}  // namespace body_trial_test
}  // namespace farrier::trials
