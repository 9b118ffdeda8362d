#include "body/scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "body/engine/mjcf.hpp"
#include "test_bodies.hpp"

namespace farrier::body {
namespace scene_test {

constexpr double kRounding = 1e-12;

std::string refusal(const Scene& scene) {
  const auto valid = validate(scene);
  return valid ? "" : valid.error().message;
}

TEST(Scene, RefusesPartsByName) {
  Scene scene;
  EXPECT_EQ(refusal(scene), "");
  scene.friction = -0.1;
  EXPECT_EQ(refusal(scene), "the friction is negative or not finite: give its coefficient");
  scene = {};
  scene.boxes.push_back({"table", {}, {1.0, 0.0, 1.0}, Eigen::Quaterniond::Identity()});
  EXPECT_EQ(refusal(scene), "box table has no volume: give three half extents in m, above zero");
  scene = {};
  scene.pushes.push_back({"side", 1.0, 0.0, {}});
  EXPECT_EQ(refusal(scene), "push side has no duration or begins before the run: give seconds above zero");
  scene = {};
  scene.payloads.push_back({"load", 1.0, 0.0, {}});
  EXPECT_EQ(refusal(scene), "payload load has no mass or begins before the run: give kg above zero");
  scene = {};
  scene.ground = attitude_of(0.0, 2.0, 0.0);
  EXPECT_EQ(refusal(scene), "the ground does not face upwards: give a slope below a right angle");
}

TEST(Scene, GivesTheImpulseOfAPushWhereverTicksFall) {
  Scene scene;
  scene.pushes.push_back({"side", 0.10037, 0.05011, {0.0, 20.0, -3.0}});
  Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
  constexpr double kPeriod_s = 1e-3;
  for (int tick = 0; tick < 300; ++tick) {
    impulse_Ns += kPeriod_s * push_force_N(scene, kPeriod_s * tick, kPeriod_s * (tick + 1));
  }
  EXPECT_LT((impulse_Ns - Eigen::Vector3d(0.0, 20.0, -3.0)).norm(), 1e-9);
  EXPECT_EQ(push_force_N(scene, 0.0, 0.1), Eigen::Vector3d::Zero());
  EXPECT_EQ(push_force_N(scene, 0.2, 0.3), Eigen::Vector3d::Zero());
}

// Moments about any point add up: compare first and second moments about the trunk's origin.
TEST(Scene, AddsAPayloadToTheTrunksMoments) {
  Draws draws(5);
  const RigidInertia trunk = random_inertia(draws, 60.0, 0.5);
  Scene scene;
  scene.payloads.push_back({"early", 1.0, 20.0, {0.1, -0.2, 0.3}});
  scene.payloads.push_back({"late", 2.0, 10.0, {-0.4, 0.0, 0.1}});
  EXPECT_EQ(loaded_trunk(trunk, scene, 0.5).mass_kg, 60.0);
  EXPECT_EQ(loaded_trunk(trunk, scene, 1.0).mass_kg, 80.0);
  const RigidInertia loaded = loaded_trunk(trunk, scene, 2.0);
  EXPECT_EQ(loaded.mass_kg, 90.0);
  const auto about_origin = [](const RigidInertia& i) {
    return SpatialInertia::of(i.mass_kg, i.com_m, i.tensor_kg_m2);
  };
  SpatialInertia sum = about_origin(trunk);
  for (const Payload& payload : scene.payloads) {
    sum = sum + SpatialInertia::of(payload.mass_kg, payload.position_m, Eigen::Matrix3d::Zero());
  }
  EXPECT_LT((about_origin(loaded).first_moment_kg_m - sum.first_moment_kg_m).norm(), kRounding);
  EXPECT_LT((about_origin(loaded).tensor_kg_m2 - sum.tensor_kg_m2).norm(), kRounding);
  EXPECT_TRUE(validate(loaded).ok());
}

TEST(Scene, TurnsByYawThenPitchThenRoll) {
  const double roll = 0.3, pitch = -0.5, yaw = 1.2;
  const Eigen::Quaterniond expected = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX());
  EXPECT_LT(attitude_of(roll, pitch, yaw).angularDistance(expected), 1e-7);
}

class Start : public testing::Test {
 protected:
  Start() {
    state_.position_m.z() = 2.0;
    body_.set_state(state_);
  }
  std::string refusal(const Scene& scene) const {
    const auto start = check_start(scene, model_, body_);
    return start ? "" : start.error().message;
  }

  BodyModel model_ = random_body(1, 3);
  RigidBody body_ = RigidBody::create(model_).value();
  BodyState state_ = BodyState::zero(3);
};

TEST_F(Start, IsRefusedInATurnedBoxAndAllowedBesideIt) {
  Box box{"block", body_.foot_position_m(0), {0.2, 0.1, 0.05}, attitude_of(0.2, 0.3, 0.7)};
  Scene scene;
  scene.boxes.push_back(box);
  EXPECT_EQ(refusal(scene), "the foot of leg leg0 starts in box block: move the box or start higher");
  const Eigen::Vector3d out = box.attitude * Eigen::Vector3d::UnitZ();
  const double radius_m = model_.legs[0].foot_radius_m;
  scene.boxes[0].centre_m = body_.foot_position_m(0) - (0.05 + radius_m + 1e-6) * out;
  EXPECT_EQ(refusal(scene), "") << "it rests on the box";
  scene.boxes[0].centre_m = body_.foot_position_m(0) - (0.05 + 0.5 * radius_m) * out;
  EXPECT_NE(refusal(scene), "") << "it is half in the box";
}

TEST_F(Start, IsRefusedBelowTheGround) {
  EXPECT_EQ(refusal({}), "");
  state_.position_m.z() -= body_.foot_position_m(0).z();
  body_.set_state(state_);
  EXPECT_EQ(refusal({}), "the foot of leg leg0 starts below the ground: start higher");
}

// 0.1 has no short binary form: a number must come back with all its digits.
TEST(Mjcf, WritesNumbersWithAllTheirDigits) {
  BodyModel model = random_body(2, 3);
  model.trunk.mass_kg = 0.1 + 0.2;
  model.legs[1].name = "\"/><x name=\"";
  const std::string text = mjcf_text(model, {}, 0.00025);
  EXPECT_NE(text.find("mass=\"0.30000000000000004\""), std::string::npos);
  EXPECT_NE(text.find("timestep=\"0.00025\""), std::string::npos);
  EXPECT_EQ(text.find("<x"), std::string::npos) << "names of legs do not become part of the text";
}

}  // namespace scene_test
}  // namespace farrier::body
