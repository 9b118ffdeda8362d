#include "body/engine/engine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "tests/support/allocation_guard.hpp"
#include "body/dynamics/rigid_body.hpp"
#include "test_bodies.hpp"

namespace farrier::body {
namespace engine_test {

// Both sides round; the largest entries of M are near 100 kg m^2, of c near 1e4 N.
constexpr double kAgreement = 1e-9;
constexpr int kPoses = 200;

double largest(const Eigen::MatrixXd& m) { return m.cwiseAbs().maxCoeff(); }

class EngineAndRigidBody : public testing::TestWithParam<int> {};

TEST_P(EngineAndRigidBody, AgreeAtRandomPosesAndVelocities) {
  const BodyModel model = random_body(GetParam(), 11);
  RigidBody body = RigidBody::create(model).value();
  auto engine = Engine::create(model, {});
  ASSERT_TRUE(engine.ok()) << engine.error().message;
  Draws draws(12);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body.joints(), draws);
    body.set_state(state);
    const EngineDynamics other = engine.value().dynamics(state);
    const MassMatrix mass = body.mass_matrix();
    ASSERT_LT(largest(mass - other.mass_matrix), kAgreement * largest(mass)) << pose;
    const VelocityVector bias = body.bias_forces();
    ASSERT_LT(largest(bias - other.bias_forces), kAgreement * largest(bias)) << pose;
    for (int leg = 0; leg < body.legs(); ++leg) {
      ASSERT_LT(largest(body.foot_position_m(leg) - other.foot_position_m[leg]), kAgreement) << pose;
      ASSERT_LT(largest(body.foot_jacobian(leg) - other.foot_jacobian[leg]), kAgreement) << pose;
      const Eigen::Vector3d rate = body.foot_jacobian_rate_times_velocity_m_s2(leg);
      ASSERT_LT(largest(rate - other.foot_bias_acceleration_m_s2[leg]), kAgreement * (1.0 + largest(rate))) << pose;
    }
  }
}

TEST_P(EngineAndRigidBody, AgreeWithAPayload) {
  BodyModel model = random_body(GetParam(), 13);
  Engine engine = Engine::create(model, {}).value();
  Scene scene;
  scene.payloads.push_back({"box", 0.0, 20.0, {0.1, -0.05, 0.2}});
  model.trunk = loaded_trunk(model.trunk, scene, 0.0);
  engine.set_trunk(model.trunk);
  RigidBody body = RigidBody::create(model).value();
  Draws draws(14);
  for (int pose = 0; pose < kPoses; ++pose) {
    const BodyState state = random_state(body.joints(), draws);
    body.set_state(state);
    const EngineDynamics other = engine.dynamics(state);
    const MassMatrix mass = body.mass_matrix();
    ASSERT_LT(largest(mass - other.mass_matrix), kAgreement * largest(mass)) << pose;
    const VelocityVector bias = body.bias_forces();
    ASSERT_LT(largest(bias - other.bias_forces), kAgreement * largest(bias)) << pose;
  }
}

INSTANTIATE_TEST_SUITE_P(Legs, EngineAndRigidBody, testing::Values(1, 4, 6));

class EngineRun : public testing::Test {
 protected:
  BodyModel model_ = random_body(4, 21);
  Engine engine_ = Engine::create(model_, {}).value();

  BodyState high_up() {
    Draws draws(22);
    BodyState state = random_state(model_.joints(), draws);
    state.position_m = {0.0, 0.0, 100.0};
    return state;
  }
  JointVector none() const { return JointVector::Zero(model_.joints()); }
};

TEST_F(EngineRun, KeepsTheStateThatItIsGiven) {
  const BodyState state = high_up();
  engine_.set_state(state);
  const BodyState kept = engine_.state();
  EXPECT_EQ(kept.position_m, state.position_m);
  EXPECT_EQ(kept.angles_rad, state.angles_rad);
  EXPECT_EQ(kept.velocity(), state.velocity());
}

TEST_F(EngineRun, EndsWithAFaultAndItsStepInPlaceOfAReset) {
  engine_.set_state(high_up());
  JointVector torques = none();
  for (int step = 0; step < 5; ++step) {
    engine_.step(torques);
  }
  EXPECT_FALSE(engine_.failure().has_value());
  const BodyState before = engine_.state();
  torques[3] = std::numeric_limits<double>::quiet_NaN();
  engine_.step(torques);
  ASSERT_TRUE(engine_.failure().has_value());
  EXPECT_EQ(engine_.failure()->fault, EngineFault::kAccelerationNotFinite);
  EXPECT_EQ(engine_.failure()->step, 5);
  EXPECT_EQ(engine_.steps(), 5);
  EXPECT_EQ(engine_.state().velocity(), before.velocity()) << "the step has no effect";
  engine_.step(none());
  EXPECT_EQ(engine_.steps(), 5) << "a failed run does not go on";
  engine_.set_state(high_up());
  EXPECT_FALSE(engine_.failure().has_value());
}

// Our own sine, of half the angle, ends at 1e6 rad.
TEST_F(EngineRun, EndsWithAFaultWhenAJointTurnsTooFar) {
  BodyState state = high_up();
  state.angles_rad[5] = 2e6 - 0.1;
  state.velocities_rad_s[5] = 50.0;
  engine_.set_state(state);
  for (int step = 0; step < 1000; ++step) {
    engine_.step(none());
  }
  EXPECT_TRUE(engine_.failure().has_value());
  EXPECT_TRUE(std::isfinite(engine_.state().angles_rad.sum()));
}

TEST_F(EngineRun, GivesTheSameBitsBesideAnotherEngine) {
  const BodyState start = high_up();
  const auto run = [this, &start](VelocityVector& end) {
    Engine engine = Engine::create(model_, {}).value();
    engine.set_state(start);
    for (int step = 0; step < 2000; ++step) {
      engine.step(JointVector::Constant(model_.joints(), 2.0));
    }
    end = engine.state().velocity();
  };
  VelocityVector alone, first, second;
  run(alone);
  std::thread one([&] { run(first); });
  std::thread other([&] { run(second); });
  one.join();
  other.join();
  EXPECT_EQ(first, alone);
  EXPECT_EQ(second, alone);
}

TEST_F(EngineRun, ContinuesFromASavedStateWithTheSameBits) {
  engine_.set_state(high_up());
  const JointVector torques = JointVector::Constant(model_.joints(), 3.0);
  for (int step = 0; step < 100; ++step) {
    engine_.step(torques);
  }
  const BodyState saved = engine_.state();
  Engine other = Engine::create(model_, {}).value();
  other.set_state(saved);
  for (int step = 0; step < 100; ++step) {
    engine_.step(torques);
    other.step(torques);
  }
  EXPECT_EQ(engine_.state().velocity(), other.state().velocity());
  EXPECT_EQ(engine_.state().angles_rad, other.state().angles_rad);
}

TEST_F(EngineRun, AllocatesNothingInAStep) {
  engine_.set_state(high_up());
  const JointVector torques = none();
  const test::AllocationGuard guard;
  engine_.step(torques);
  const BodyState state = engine_.state();
  engine_.set_trunk(model_.trunk);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_TRUE(std::isfinite(state.position_m.z()));
}

// A robot without torques falls on its side or its belly, and stays above the ground.
TEST(Engine, LetsALimpRobotLandOnTrunkAndKnees) {
  BodyModel model = random_body(4, 21);
  model.box = TrunkBox{.centre_m = Eigen::Vector3d::Zero(), .half_extents_m = {0.4, 0.2, 0.1}};
  for (LegModel& leg : model.legs) {
    leg.knee_radius_m = 0.03;
    for (Link& link : leg.links) {
      link.damping_Nms_rad = 1.0;
    }
  }
  Engine engine = Engine::create(model, {}).value();
  RigidBody body = RigidBody::create(model).value();
  BodyState state = BodyState::zero(body.joints());
  state.position_m.z() = 1.5;
  engine.set_state(state);
  constexpr double kSunk_m = 0.01;
  for (int step = 0; step < 20000; ++step) {
    engine.step(JointVector::Zero(body.joints()));
    ASSERT_FALSE(engine.failure().has_value()) << to_string(engine.failure()->fault) << " at step " << step;
  }
  const BodyState lies = engine.state();
  EXPECT_LT(lies.position_m.z(), 1.0);
  for (const double x : {-0.4, 0.4}) {
    for (const double y : {-0.2, 0.2}) {
      for (const double z : {-0.1, 0.1}) {
        EXPECT_GT((lies.position_m + lies.attitude * Eigen::Vector3d(x, y, z)).z(), -kSunk_m);
      }
    }
  }
}

TEST(Engine, HoldsAHingeBetweenItsStops) {
  constexpr double kGives_rad = 0.05;
  BodyModel model = random_body(1, 22);
  model.gravity_m_s2 = 0.0;
  model.legs[0].links[2].stops = {-0.5, 0.3};
  for (Link& link : std::span(model.legs[0].links).first(2)) {
    link.damping_Nms_rad = 100.0;  // else the robot spins ever faster
  }
  for (const double torque_Nm : {-20.0, 20.0}) {
    Engine engine = Engine::create(model, {}).value();
    BodyState state = BodyState::zero(3);
    state.position_m.z() = 10.0;  // above the ground
    engine.set_state(state);
    JointVector torques_Nm = JointVector::Zero(3);
    torques_Nm[2] = torque_Nm;
    for (int step = 0; step < 8000; ++step) {
      engine.step(torques_Nm);
      ASSERT_GT(engine.state().angles_rad[2], -0.5 - kGives_rad) << step;
      ASSERT_LT(engine.state().angles_rad[2], 0.3 + kGives_rad) << step;
    }
  }
}

TEST(Engine, TakesTheSameStepsByThemselves) {
  const BodyModel model = random_body(2, 23);
  Engine watched = Engine::create(model, {}).value();
  Engine bare = Engine::create(model, {}).value();
  JointVector torques_Nm = JointVector::Constant(6, 2.0);
  for (int step = 0; step < 400; ++step) {
    watched.step(torques_Nm);
  }
  bare.bare_steps(torques_Nm, 400);
  EXPECT_EQ(bare.state().velocity(), watched.state().velocity());
}

TEST(Engine, RefusesAStepOutOfRange) {
  EXPECT_FALSE(Engine::create(random_body(1, 1), {}, {.step_s = 0.0}).ok());
  EXPECT_FALSE(Engine::create(random_body(1, 1), {}, {.step_s = 0.1}).ok());
}

TEST(Engine, RefusesABodyThatTheModelsCheckRefuses) {
  BodyModel model = random_body(1, 1);
  model.legs[0].foot_radius_m = -1.0;
  const auto engine = Engine::create(model, {});
  ASSERT_FALSE(engine.ok());
  EXPECT_EQ(engine.error().message, "leg leg0: the foot has no size: give the radius of its sphere in m, above zero");
}

}  // namespace engine_test
}  // namespace farrier::body
