#pragma once

#include <cstdint>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Cost of a robot's tick on a ground, all on one core, and of what a user would take instead of its parts. Times of a
/// part are wall time, means of the fastest round.
struct BodyBench {
  double dynamics_s;  ///< RigidBody: mass matrix, bias forces, positions, Jacobians and bias accelerations of feet
  double mujoco_dynamics_s;  ///< MuJoCo: the same of the same model
  double forces_s;           ///< ForceDistribution: one wrench over the feet on the ground
  double slsqp_s;            ///< NLopt's SLSQP, a sequential quadratic programme with a dense active set: the same
  double forces_difference;  ///< largest difference of a force of the two, over the largest force
  double tick_s;             ///< processor time of a tick: world and controller
  double bare_step_s;        ///< processor time of MuJoCo's steps of a tick alone, with the same torques
  double run_ratio;          ///< the one over the other, median of the rounds
  std::int64_t allocations;  ///< by RigidBody, ForceDistribution and the ticks; -1 when they were not counted
};

/// Lets the robot trot and times `rounds` (>= 1) times 500 ticks. `allocations_so_far` reads the program's counter of
/// allocations; null if there is none. Refuses a robot without body or locomotion, and a run that cannot be repeated.
Result<BodyBench> bench_body(const robot::Robot& robot, int rounds, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
