#include "bench/command/body_part.hpp"

#include <cstdio>

#include "bench/bench_body.hpp"
#include "bench/bench_walk.hpp"
#include "bench/command/allocation_count.hpp"

namespace farrier::cli {
namespace {

constexpr int kRounds = 20;
// The least the product promises.
constexpr double kRunRatio = 2.5;
constexpr double kRealTime = 2.0;
constexpr double kDynamicsSpeedup = 1.0;
constexpr double kForcesSpeedup = 3.0;
constexpr double kForcesDifference = 0.02;
constexpr double kControlUs = 100.0;  // a tenth of the period

}  // namespace

bool has_body_part() noexcept { return true; }

Result<Done> measure_body(const robot::Robot& robot, report::Figures& figures) {
  std::fputs("body: a tick of the robot on a ground against MuJoCo alone, and its parts\n", stderr);
  const auto body = FARRIER_TRY(bench::bench_body(robot, kRounds, allocation_count));
  figures.add("bench.body.dynamics_us", 1e6 * body.dynamics_s);
  figures.add("bench.body.mujoco_dynamics_us", 1e6 * body.mujoco_dynamics_s);
  figures.add("bench.body.dynamics_speedup", body.mujoco_dynamics_s / body.dynamics_s, kDynamicsSpeedup);
  figures.add("bench.body.forces_us", 1e6 * body.forces_s);
  figures.add("bench.body.slsqp_us", 1e6 * body.slsqp_s);
  figures.add("bench.body.forces_speedup", body.slsqp_s / body.forces_s, kForcesSpeedup);
  figures.add("bench.body.forces_difference", body.forces_difference, kForcesDifference);
  figures.add("bench.body.tick_us", 1e6 * body.tick_s);
  figures.add("bench.body.mujoco_steps_us", 1e6 * body.bare_step_s);
  figures.add("bench.body.run_ratio", body.run_ratio, kRunRatio);
  figures.add("bench.body.allocations", static_cast<double>(body.allocations), 0.0);
  std::fputs("body: the same on the robot's own actuators\n", stderr);
  const auto on_ground = robot::load_robot(robot.path, {.on_ground = true});
  if (!on_ground) {
    return Error{config::to_string(on_ground.error())};
  }
  const auto walk = FARRIER_TRY(bench::bench_walk(on_ground.value(), kRounds));
  figures.add("bench.walk.tick_us", 1e6 * walk.tick_s);
  figures.add("bench.walk.mujoco_steps_us", 1e6 * walk.bare_step_s);
  figures.add("bench.walk.run_ratio", walk.run_ratio, kRunRatio);
  figures.add("bench.walk.real_time", walk.real_time, kRealTime);
  const auto control = FARRIER_TRY(bench::bench_control_tick(on_ground.value(), kRounds, allocation_count));
  figures.add("bench.walk.control_us", 1e6 * control.tick_s, kControlUs);
  figures.add("bench.walk.control_allocations", static_cast<double>(control.allocations), 0.0);
  return Done{};
}

}  // namespace farrier::cli
