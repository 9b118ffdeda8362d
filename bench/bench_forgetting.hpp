#pragma once

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Times in which the method aff, Hubacher (2014), 9.1.1, forgets after a change of load and stops forgetting. In s, of
/// the slowest seed; infinite where it never happens.
struct ForgettingBench {
  double fall_s;    ///< from the change until the least lambda of a row is below kForgets
  double return_s;  ///< from the change until the mean of the least lambda over 20 ticks is above kRemembers
};
inline constexpr double kForgets = 0.97;
inline constexpr double kRemembers = 0.99;

/// The joint of the robot whose load changes most between swing and stance, by its linear model, with its sensors' noise
/// and 2 % of its valve's current of either sign. The load changes from swing to stance after 2 s. Seeds 1 to `seeds`
/// (>= 1). Refuses a robot whose joints are electric.
Result<ForgettingBench> bench_forgetting(const robot::Robot& robot, int seeds);

}  // namespace farrier::bench
