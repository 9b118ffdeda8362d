#include "bench/bench_walk.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "bench/walk_rounds.hpp"
#include "body/engine/engine.hpp"
#include "core/median.hpp"
#include "locomotion/trot_controller.hpp"
#include "robot/locomotion_model.hpp"
#include "robot/locomotion_params.hpp"
#include "trials/body/actuated_robot.hpp"
#include "trials/body/controller_driver.hpp"

namespace farrier::bench {

Result<WalkBench> bench_walk(const robot::Robot& robot, int rounds) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
  }
  const auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  auto actuated = FARRIER_TRY(trials::ActuatedRobot::create(robot, robot, {}, 1));
  const world::BodyWorld& world = actuated.robot().body();
  locomotion::TrotController controller(*robot.locomotion, robot::locomotion_plan(robot.plan), model);
  trials::ControllerDriver driver(controller, benched_walk(), robot.period_s);
  auto engine =
      FARRIER_TRY(body::Engine::create(world.model(), {}, {.step_s = robot.period_s / world.steps_per_tick()}));
  std::vector<double> torques_Nm(actuated.joints(), 0.0);
  const auto tick = [&] {
    driver.step(actuated, torques_Nm);
    return actuated.advance(torques_Nm);
  };
  const auto failure = [&] { return Error{actuated.failure().value_or("the robot cannot be simulated")}; };
  while (static_cast<double>(actuated.tick()) * robot.period_s < kSettled_s) {
    if (!tick()) {
      return failure();
    }
  }
  WalkBench bench{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), 0.0, 0.0};
  std::vector<double> ratios, speeds;
  for (int round = 0; round < std::max(rounds, 1); ++round) {
    double tick_s = 0.0, bare_s = 0.0;
    for (int i = 0; i < kTicksOfARound; ++i) {
      engine.set_state(world.state());
      const double start_s = processor_s();
      engine.bare_steps(actuated.robot().actuators()->torques_Nm(), world.steps_per_tick());
      const double between_s = processor_s();
      const bool moved = tick();
      tick_s += processor_s() - between_s;
      bare_s += between_s - start_s;
      if (!moved) {
        return failure();
      }
    }
    bench.tick_s = std::min(bench.tick_s, tick_s / kTicksOfARound);
    bench.bare_step_s = std::min(bench.bare_step_s, bare_s / kTicksOfARound);
    ratios.push_back(tick_s / bare_s);
    speeds.push_back(kTicksOfARound * robot.period_s / tick_s);
  }
  bench.run_ratio = median(ratios);
  bench.real_time = median(speeds);
  return bench;
}

Result<ControlTickBench> bench_control_tick(const robot::Robot& robot, int rounds,
                                            std::int64_t (*allocations_so_far)()) {
  if (!robot.can_walk()) {
    return Error{robot.cannot_walk_error()};
  }
  const auto model = FARRIER_TRY(robot::LocomotionModel::create(*robot.body));
  auto actuated = FARRIER_TRY(trials::ActuatedRobot::create(robot, robot, {}, 1, 1, true));
  locomotion::TrotController controller(*robot.locomotion, robot::locomotion_plan(robot.plan), model);
  trials::ControllerDriver driver(controller, benched_walk(), robot.period_s);
  std::vector<double> torques_Nm(actuated.joints(), 0.0);
  const auto decide = [&] {
    driver.step(actuated, torques_Nm);
    actuated.decide(torques_Nm);
  };
  ControlTickBench bench{std::numeric_limits<double>::infinity(), allocations_so_far != nullptr ? 0 : -1};
  const auto settled = static_cast<Tick>(kSettled_s / robot.period_s);
  const Tick end = settled + static_cast<Tick>(std::max(rounds, 1)) * kTicksOfARound;
  double round_s = 0.0;
  while (actuated.tick() < end) {
    const bool timed = actuated.tick() >= settled;
    const std::int64_t before = timed && allocations_so_far != nullptr ? allocations_so_far() : 0;
    const double start_s = processor_s();
    decide();
    round_s += processor_s() - start_s;
    if (timed && allocations_so_far != nullptr) {
      bench.allocations += allocations_so_far() - before;
    }
    if (!actuated.move()) {
      return Error{actuated.failure().value_or("the robot cannot be simulated")};
    }
    if (actuated.tick() % kTicksOfARound == 0) {
      bench.tick_s = timed ? std::min(bench.tick_s, round_s / kTicksOfARound) : bench.tick_s;
      round_s = 0.0;
    }
  }
  return bench;
}

}  // namespace farrier::bench
