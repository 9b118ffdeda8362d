#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/noise.hpp"
#include "standing.hpp"

namespace farrier::body {
namespace physics_test {

constexpr double kStep_s = 0.00025;
constexpr int kStepsPerTick = 4;

class HyqPhysics : public testing::Test {
 protected:
  const robot::Robot hyq_ = load_hyq();
  const BodyModel& model_ = *hyq_.body;
  RigidBody body_ = RigidBody::create(model_).value();
  const BodyState standing_ = standing_state(hyq_, body_);
  const StanceController stance_{body_, standing_, body_.total_mass_kg(), model_.gravity_m_s2};

  // Ticks of 1 ms under the stance controller. `each` is called after every tick.
  template <class Each>
  void stand(Engine& engine, int ticks, const Scene& scene, Each&& each) {
    for (int tick = 0; tick < ticks; ++tick) {
      const BodyState state = engine.state();
      body_.set_state(state);
      const JointVector torques_Nm = stance_.torques_Nm(body_, state);
      const TrunkWrench wrench{push_force_N(scene, 1e-3 * tick, 1e-3 * (tick + 1)), Eigen::Vector3d::Zero()};
      for (int step = 0; step < kStepsPerTick; ++step) {
        engine.step(torques_Nm, wrench);
      }
      each(tick);
    }
    body_.set_state(engine.state());
  }

  double energy_J(const Engine& engine) {
    body_.set_state(engine.state());
    return body_.kinetic_energy_J() + body_.potential_energy_J();
  }
};

// A second of fall turns 9.81 m of height to speed. The engine's Euler steps add g dt/2 per second to the speed.
TEST_F(HyqPhysics, KeepsTheEnergyOfAFreeFall) {
  Engine engine = Engine::create(model_, {}).value();
  BodyState state = standing_;
  state.position_m.z() = 20.0;
  state.angular_velocity_rad_s = {0.5, 1.0, -0.3};
  engine.set_state(state);
  const double before_J = energy_J(engine);
  const JointVector none = JointVector::Zero(body_.joints());
  for (int step = 0; step < static_cast<int>(1.0 / kStep_s); ++step) {
    engine.step(none);
  }
  const double after_J = energy_J(engine);
  EXPECT_GT(body_.kinetic_energy_J(), 3500.0);
  EXPECT_NEAR(after_J, before_J, 0.01 * body_.kinetic_energy_J());
}

// Without gravity and ground the trunk swings against the legs, whose knees are thrown at 5 rad/s.
TEST_F(HyqPhysics, KeepsTheEnergyOfASwingingLeg) {
  BodyModel weightless = model_;
  weightless.gravity_m_s2 = 0.0;
  for (LegModel& leg : weightless.legs) {
    for (Link& link : leg.links) {
      link.damping_Nms_rad = 0.0;
    }
  }
  Engine engine = Engine::create(weightless, {}).value();
  BodyState state = standing_;
  state.position_m.z() = 20.0;
  state.velocities_rad_s[1] = 4.0;
  state.velocities_rad_s[2] = -5.0;
  engine.set_state(state);
  body_ = RigidBody::create(weightless).value();
  const double before_J = energy_J(engine);
  const JointVector none = JointVector::Zero(body_.joints());
  double worst_J = 0.0;
  for (int step = 0; step < static_cast<int>(1.0 / kStep_s); ++step) {
    engine.step(none);
    worst_J = std::max(worst_J, std::abs(energy_J(engine) - before_J));
  }
  EXPECT_GT(std::abs(engine.state().angles_rad[2] - state.angles_rad[2]), 1.0) << "the knee must turn";
  EXPECT_LT(worst_J, 0.01 * before_J);
}

TEST_F(HyqPhysics, StandsForFiveSecondsOnTheForcesThatJacobiansGive) {
  Engine engine = Engine::create(model_, {}).value();
  engine.set_state(standing_);
  double tilt = 0.0;
  stand(engine, 5000, {}, [&](int) { tilt = std::max(tilt, engine.state().attitude.vec().norm()); });
  ASSERT_FALSE(engine.failure().has_value()) << to_string(engine.failure()->fault);
  EXPECT_NEAR(engine.state().position_m.z(), standing_.position_m.z(), 2e-3);
  EXPECT_LT(2.0 * tilt, 0.005);
  double sum_N = 0.0;
  for (int leg = 0; leg < body_.legs(); ++leg) {
    EXPECT_NEAR(engine.contact_force_N(leg).z(), stance_.force_N(leg), 0.01 * stance_.force_N(leg)) << leg;
    sum_N += engine.contact_force_N(leg).z();
  }
  EXPECT_NEAR(sum_N, body_.total_mass_kg() * model_.gravity_m_s2, 0.01 * sum_N);
}

// In the stance v' and v are zero:  S' tau + sum of J_i' f_i = c.
TEST_F(HyqPhysics, BalancesTorquesContactForcesAndWeight) {
  Engine engine = Engine::create(model_, {}).value();
  engine.set_state(standing_);
  stand(engine, 5000, {}, [](int) {});
  VelocityVector residual = body_.bias_forces();
  residual.tail(body_.joints()) -= stance_.torques_Nm(body_, engine.state());
  for (int leg = 0; leg < body_.legs(); ++leg) {
    residual -= body_.foot_jacobian(leg).transpose() * engine.contact_force_N(leg);
  }
  const double weight_N = body_.total_mass_kg() * model_.gravity_m_s2;
  EXPECT_LT(residual.head<3>().norm(), 0.01 * weight_N);
  EXPECT_LT(residual.tail(body_.joints() + 3).cwiseAbs().maxCoeff(), 0.01 * weight_N * 0.35);  // a leg's length
}

TEST_F(HyqPhysics, TakesUpTheImpulseOfAPush) {
  Scene scene;
  scene.friction = 0.0;
  scene.pushes.push_back({"side", 0.1, 0.05, {0.0, 20.0, 0.0}});
  Engine engine = Engine::create(model_, scene).value();
  engine.set_state(standing_);
  stand(engine, 200, scene, [](int) {});
  const double momentum_Ns = (body_.mass_matrix() * engine.state().velocity())[1];
  EXPECT_NEAR(momentum_Ns, 20.0, 0.01 * 20.0);
}

TEST_F(HyqPhysics, StandsOnASlopeByFrictionAndSlidesWithout) {
  for (const double friction : {0.8, 0.05}) {
    Scene scene;
    scene.friction = friction;
    scene.ground = attitude_of(0.0, 0.15, 0.0);
    Engine engine = Engine::create(model_, scene).value();
    BodyState state = standing_;
    state.attitude = scene.ground;
    state.position_m = scene.ground * standing_.position_m;
    engine.set_state(state);
    stand(engine, 1000, scene, [](int) {});
    const double slide_m = (engine.state().position_m - state.position_m).norm();
    EXPECT_EQ(slide_m<0.05, friction> 0.15) << friction << ": " << slide_m;
  }
}

TEST_F(HyqPhysics, CarriesAPayloadOnItsFeet) {
  Scene scene;
  scene.payloads.push_back({"box", 0.0, 20.0, {0.0, 0.0, 0.1}});
  Engine engine = Engine::create(model_, scene).value();
  engine.set_trunk(loaded_trunk(model_.trunk, scene, 0.0));
  engine.set_state(standing_);
  stand(engine, 2000, scene, [](int) {});
  double sum_N = 0.0;
  for (int leg = 0; leg < body_.legs(); ++leg) {
    sum_N += engine.contact_force_N(leg).z();
  }
  EXPECT_NEAR(sum_N, (body_.total_mass_kg() + 20.0) * model_.gravity_m_s2, 0.01 * sum_N);
}

// Position and velocity are all the state there is, in contact too.
TEST_F(HyqPhysics, ContinuesAStanceFromASavedStateWithTheSameBits) {
  Engine engine = Engine::create(model_, {}).value();
  engine.set_state(standing_);
  stand(engine, 100, {}, [](int) {});
  const BodyState saved = engine.state();
  Engine other = Engine::create(model_, {}).value();
  other.set_state(saved);
  stand(engine, 100, {}, [](int) {});
  stand(other, 100, {}, [](int) {});
  EXPECT_EQ(engine.state().velocity(), other.state().velocity());
  EXPECT_EQ(engine.state().attitude.coeffs(), other.state().attitude.coeffs());
}

std::uint64_t hash_of(const BodyState& state, std::uint64_t before) {
  std::string bytes(sizeof before, '\0');
  std::memcpy(bytes.data(), &before, sizeof before);
  const auto append = [&bytes](const auto& numbers) {
    bytes.append(reinterpret_cast<const char*>(numbers.data()),
                 sizeof(double) * static_cast<std::size_t>(numbers.size()));
  };
  append(state.position_m);
  append(state.attitude.coeffs());
  append(state.angles_rad);
  append(state.velocity());
  return stable_hash(bytes);
}

// Ten seconds on blocks under a push: the robot rocks and slips.
TEST_F(HyqPhysics, PrintsTheHashOfARun) {
  Scene scene;
  scene.pushes.push_back({"side", 1.0, 0.1, {10.0, 60.0, 0.0}});
  scene.boxes.push_back({"block", {0.0, 1.0, 0.0}, {0.5, 0.7, 0.03}, attitude_of(0.02, -0.03, 0.4)});
  scene.ground = attitude_of(0.01, 0.02, 0.0);
  Engine engine = Engine::create(model_, scene).value();
  BodyState state = standing_;
  state.position_m.z() += 0.03;
  engine.set_state(state);
  std::uint64_t hash = 0;
  stand(engine, 10000, scene, [&](int) { hash = hash_of(engine.state(), hash); });
  ASSERT_FALSE(engine.failure().has_value()) << to_string(engine.failure()->fault);
  std::printf("hash %016llx\n", static_cast<unsigned long long>(hash));
}

std::string hash_under(const std::string& environment) {
  const std::string command =
      environment + " exec /proc/" + std::to_string(getpid()) + "/exe --gtest_filter=HyqPhysics.PrintsTheHashOfARun";
  FILE* output = popen(command.c_str(), "r");
  std::string hash;
  std::array<char, 256> line{};
  while (output != nullptr && std::fgets(line.data(), line.size(), output) != nullptr) {
    if (std::strncmp(line.data(), "hash ", 5) == 0) {
      hash = line.data();
    }
  }
  return output != nullptr && pclose(output) == 0 ? hash : "";
}

// The C library has other variants of its functions for processors without FMA. They must not reach the engine.
TEST(Engine, GivesTheSameBitsWithTheFunctionsOfAnOlderProcessor) {
  const std::string here = hash_under("");
  EXPECT_NE(here, "");
  EXPECT_EQ(here, hash_under("GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-AVX"));
}

}  // namespace physics_test
}  // namespace farrier::body
