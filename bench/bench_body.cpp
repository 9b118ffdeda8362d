#include "bench/bench_body.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "bench/slsqp_forces.hpp"
#include "bench/walk_rounds.hpp"
#include "body/engine/engine.hpp"
#include "core/median.hpp"
#include "locomotion/force_distribution.hpp"
#include "locomotion/trot_controller.hpp"
#include "robot/locomotion_model.hpp"
#include "robot/locomotion_params.hpp"
#include "trials/body/controller_driver.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::bench {
namespace {

constexpr double kUnmeasured_s = std::numeric_limits<double>::infinity();

template <class Work>
double wall_s(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One wrench, and the feet that shall bear it.
struct Load {
  locomotion::Wrench wrench;
  locomotion::PerLeg<locomotion::Contact> contacts;
  int count = 0;
};

/// A robot that trots. It is recorded round by round.
class Walk {
 public:
  Walk(const robot::Robot& robot, world::BodyWorld world, const robot::LocomotionModel& model)
      : world_(std::move(world)),
        controller_(*robot.locomotion, robot::locomotion_plan(robot.plan), model),
        driver_(controller_, benched_walk(), robot.period_s),
        torques_Nm_(world_.joints(), 0.0) {}

  bool tick() noexcept {
    driver_.step(world_, torques_Nm_);
    return world_.advance(torques_Nm_);
  }

  const world::BodyWorld& world() const noexcept { return world_; }
  body::JointVector torques_Nm() const {
    return Eigen::Map<const Eigen::VectorXd>(torques_Nm_.data(), world_.body().joints());
  }

  Load load() const {
    Load load{.wrench = controller_.state().wrench, .contacts = {}};
    for (int leg = 0; leg < world_.body().legs(); ++leg) {
      if (controller_.state().actions[leg] == locomotion::LegAction::kStance) {
        load.contacts[load.count++] = {.lever_m =
                                           world_.body().foot_position_m(leg) - world_.body().centre_of_mass_m()};
      }
    }
    return load;
  }

 private:
  world::BodyWorld world_;
  locomotion::TrotController controller_;
  trials::ControllerDriver driver_;
  std::vector<double> torques_Nm_;
};

void own_dynamics(body::RigidBody& body, const body::BodyState& state, body::EngineDynamics& dynamics) noexcept {
  body.set_state(state);
  dynamics.mass_matrix = body.mass_matrix();
  dynamics.bias_forces = body.bias_forces();
  for (int leg = 0; leg < body.legs(); ++leg) {
    dynamics.foot_position_m[leg] = body.foot_position_m(leg);
    dynamics.foot_jacobian[leg] = body.foot_jacobian(leg);
    dynamics.foot_bias_acceleration_m_s2[leg] = body.foot_jacobian_rate_times_velocity_m_s2(leg);
  }
}

/// The inputs of the parts that a round has recorded: states before the ticks, torques of the ticks, loads after them.
struct Round {
  std::vector<body::BodyState> states;
  std::vector<body::JointVector> torques_Nm;
  std::vector<Load> loads;
};

class Bench {
 public:
  Bench(const robot::Robot& robot, body::Engine engine, body::RigidBody body, std::int64_t (*allocations_so_far)())
      : engine_(std::move(engine)),
        body_(std::move(body)),
        forces_(robot.locomotion->forces),
        slsqp_(robot.locomotion->forces),
        count_(allocations_so_far) {}

  Result<Done> round(Walk& walk) {
    const Round round = FARRIER_TRY(ticks(walk));
    FARRIER_TRY(bare_steps(round, walk.world()));
    dynamics(round);
    return distribution(round);
  }

  BodyBench result() {
    bench_.run_ratio = median(ratios_);
    bench_.forces_difference = difference_N_ / largest_N_;
    bench_.allocations = count_ != nullptr ? allocations_ : -1;
    return bench_;
  }

 private:
  template <class Work>
  void counting(const Work& work) {
    const std::int64_t before = count_ != nullptr ? count_() : 0;
    work();
    allocations_ += (count_ != nullptr ? count_() : 0) - before;
  }

  // The recording is not part of the time.
  Result<Round> ticks(Walk& walk) {
    Round round;
    double spent_s = 0.0;
    bool moved = true;
    for (int tick = 0; tick < kTicksOfARound && moved; ++tick) {
      round.states.push_back(walk.world().state());
      counting([&] {
        const double start_s = processor_s();
        moved = walk.tick();
        spent_s += processor_s() - start_s;
      });
      round.torques_Nm.push_back(walk.torques_Nm());
      round.loads.push_back(walk.load());
    }
    if (!moved) {
      return Error{walk.world().failure().value_or("the robot cannot be simulated")};
    }
    tick_s_ = spent_s / kTicksOfARound;
    bench_.tick_s = std::min(bench_.tick_s, tick_s_);
    return round;
  }

  Result<Done> bare_steps(const Round& round, const world::BodyWorld& world) {
    engine_.set_state(round.states.front());
    double spent_s = 0.0;
    for (const body::JointVector& torques_Nm : round.torques_Nm) {
      const double start_s = processor_s();
      engine_.bare_steps(torques_Nm, world.steps_per_tick());
      spent_s += processor_s() - start_s;
    }
    if (engine_.state().velocity() != world.state().velocity()) {
      return Error{"MuJoCo's steps by themselves lead to another state than those of the run"};
    }
    bench_.bare_step_s = std::min(bench_.bare_step_s, spent_s / kTicksOfARound);
    ratios_.push_back(tick_s_ * kTicksOfARound / spent_s);
    return Done{};
  }

  void dynamics(const Round& round) {
    body::EngineDynamics dynamics;
    counting([&] {
      bench_.dynamics_s = std::min(bench_.dynamics_s, wall_s([&] {
                                                        for (const body::BodyState& state : round.states) {
                                                          own_dynamics(body_, state, dynamics);
                                                        }
                                                      }) / kTicksOfARound);
    });
    bench_.mujoco_dynamics_s = std::min(bench_.mujoco_dynamics_s, wall_s([&] {
                                                                    for (const body::BodyState& state : round.states) {
                                                                      dynamics = engine_.dynamics(state);
                                                                    }
                                                                  }) / kTicksOfARound);
  }

  Result<Done> distribution(const Round& round) {
    using Forces = locomotion::PerLeg<Eigen::Vector3d>;
    std::vector<Forces> own(round.loads.size()), others(round.loads.size());
    bool solved = true;
    counting([&] {
      bench_.forces_s =
          std::min(bench_.forces_s, wall_s([&] {
                                      for (std::size_t i = 0; i < own.size(); ++i) {
                                        const Load& load = round.loads[i];
                                        forces_.distribute(load.wrench, load.contacts, load.count, own[i]);
                                      }
                                    }) / kTicksOfARound);
    });
    bench_.slsqp_s = std::min(
        bench_.slsqp_s, wall_s([&] {
                          for (std::size_t i = 0; i < own.size(); ++i) {
                            const Load& load = round.loads[i];
                            solved = slsqp_.distribute(load.wrench, load.contacts, load.count, others[i]) && solved;
                          }
                        }) / kTicksOfARound);
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (int foot = 0; foot < round.loads[i].count; ++foot) {
        difference_N_ = std::max(difference_N_, (own[i][foot] - others[i][foot]).norm());
        largest_N_ = std::max(largest_N_, own[i][foot].norm());
      }
    }
    if (!solved) {
      return Error{"SLSQP finds no forces for a wrench of the trot"};
    }
    return Done{};
  }

  body::Engine engine_;
  body::RigidBody body_;
  locomotion::ForceDistribution forces_;
  SlsqpForces slsqp_;
  std::int64_t (*count_)();
  std::int64_t allocations_ = 0;
  BodyBench bench_{
      kUnmeasured_s, kUnmeasured_s, kUnmeasured_s, kUnmeasured_s, 0.0, kUnmeasured_s, kUnmeasured_s, 0.0, -1};
  double tick_s_ = 0.0, difference_N_ = 0.0, largest_N_ = 0.0;
  std::vector<double> ratios_;
};

}  // namespace

Result<BodyBench> bench_body(const robot::Robot& robot, int rounds, std::int64_t (*allocations_so_far)()) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
  }
  const auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  Walk walk(robot, FARRIER_TRY(world::BodyWorld::create(robot, {}, 1, trials::kTrotNoise)), model);
  const world::BodyWorld& world = walk.world();
  while (static_cast<double>(world.tick()) * robot.period_s < kSettled_s) {
    if (!walk.tick()) {
      return Error{world.failure().value_or("the robot cannot be simulated")};
    }
  }
  Bench bench(robot,
              FARRIER_TRY(body::Engine::create(world.model(), {}, {.step_s = robot.period_s / world.steps_per_tick()})),
              FARRIER_TRY(body::RigidBody::create(world.model())), allocations_so_far);
  for (int round = 0; round < std::max(rounds, 1); ++round) {
    FARRIER_TRY(bench.round(walk));
  }
  return bench.result();
}

}  // namespace farrier::bench
