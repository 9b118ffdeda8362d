#pragma once

#include <cstdint>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Cost of a tick of a robot that walks on its own actuators, all on one core: locomotion, the controllers of all joints,
/// valves, oil, supply and rigid bodies.
struct WalkBench {
  double tick_s;       ///< processor time, of the fastest round
  double bare_step_s;  ///< processor time of MuJoCo's steps of a tick alone, from the same states, of the fastest round
  double run_ratio;    ///< the one over the other, median of the rounds
  double real_time;    ///< simulated time over processor time, median of the rounds
};

/// Lets the robot trot and times `rounds` (>= 1) times 500 ticks. `robot` is loaded for a ground. Refuses a robot without
/// body or locomotion, and one that cannot be simulated.
Result<WalkBench> bench_walk(const robot::Robot& robot, int rounds);

/// Cost of what the robot computes in a tick of such a walk while its gains adapt: estimates, update logic, force control,
/// state estimate and force distribution. The simulation is not counted.
struct ControlTickBench {
  double tick_s;             ///< processor time, of the fastest round
  std::int64_t allocations;  ///< of all ticks, -1 when they were not counted
};

/// Likewise. `allocations_so_far` reads the program's counter of allocations; null if there is none.
Result<ControlTickBench> bench_control_tick(const robot::Robot& robot, int rounds,
                                            std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
