#pragma once

#include <functional>

#include "control/design/lqr.hpp"
#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::trials {

/// Change on the way of the valve current to the joint.
struct LoopChange {
  double gain = 1.0;         ///< factor
  double delay_ticks = 0.0;  ///< beyond the delay of the gains; 0 to kLongestDelay_ticks
};
inline constexpr double kLongestDelay_ticks = 60.0;

/// A joint's loop as it runs: the nonlinear joint under its load, its sensors without noise, their filters, the
/// equaliser and the run-time controller.
struct RunningLoop {
  robot::Joint joint;
  plant::LoadParams load;
  control::Gains gains;
  double period_s;
};

/// True if the loop recovers from a small push within five thousand ticks. Refuses a joint that cannot be simulated. The
/// current changes within a tick where its delay ends there.
Result<bool> is_stable(const RunningLoop& loop, const LoopChange& change);

/// Smallest factor of a change that makes the loop unstable; `of` gives the change for a factor. A loop may be stable
/// again beyond. Tried are 0.3, 0.5, 0.7, 0.8 and, in steps of 0.01, 0.9 to 1.1, which is returned where all are stable;
/// within those steps the middle of one. Refuses as is_stable.
Result<double> first_unstable(const RunningLoop& loop, const std::function<LoopChange(double factor)>& of);

}  // namespace farrier::trials
