#pragma once

#include <cstdint>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Cost of one tick of every joint of a robot, all on one core: controllers, estimators, poles and update logic, an
/// estimate looked at in every tick, and none that leads to a redesign. Nothing is carried over a bus.
struct TickBench {
  double tick_s;             ///< wall time per tick of all joints, mean of the fastest round
  double estimation_s;       ///< EstimatorService::take and estimate alone, likewise
  double update_logic_s;     ///< Supervisor::take and step alone
  double control_s;          ///< JointNode::step alone
  std::int64_t allocations;  ///< during all of the above, -1 when they were not counted
};

/// Lets the robot trot in simulation and times its cores, `rounds` (>= 1) times. Their inputs are the recorded sensors
/// and commands of the stride after the one in which it reached full length. `allocations_so_far` reads the program's
/// counter of allocations; null if there is none. Refuses a robot that cannot be simulated, controlled or estimated,
/// and reports a redesign that falls into the timed part.
Result<TickBench> bench_tick(const robot::Robot& robot, int rounds, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
