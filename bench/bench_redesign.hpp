#pragma once

#include <cstdint>

#include "core/result.hpp"
#include "robot/robot.hpp"

namespace farrier::bench {

/// Cost of new gains.
struct RedesignBench {
  double redesign_s;         ///< wall time per SlotUpdate::look that ends in kAccepted: from an estimate to new gains,
                             ///< every check included; mean of the fastest round, for the slower of the loop delays
  double lqr_s;              ///< of that, one design_lqr alone, likewise
  int redesigns;             ///< different ones in a round of one loop delay
  std::int64_t allocations;  ///< during all of the above, -1 when they were not counted
};

/// Times redesigns, `rounds` (>= 1) times each. For every joint of the robot and either loop delay it has, there are
/// first gains for its swing and for its stance load, and estimates of both with other masses, damping and valve gains.
/// The estimates that the update logic accepts are timed. Refuses a robot without one, with the reason, and reports a
/// timed one that is refused.
Result<RedesignBench> bench_redesign(const robot::Robot& robot, int rounds,
                                     std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
