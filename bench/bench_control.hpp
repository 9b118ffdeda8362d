#pragma once

#include <cstdint>

namespace farrier::bench {

/// Cost of one tick of the force controller.
struct ControlBench {
  double step_s;              ///< wall time per ForceController::step, mean of the fastest of five rounds
  double gain_change_s;       ///< per ForceController::set_gains, likewise
  double design_s;            ///< per design_lqr of a leg's controller for one tick of delay, likewise
  std::int64_t allocations;   ///< during all of the above, -1 when they were not counted
};

/// Runs `steps` (>= 1) ticks in closed loop around a HyQ-like leg in stance, a hundredth as many designs.
/// `allocations_so_far` reads the program's counter of allocations; null where there is none.
ControlBench bench_control(int steps, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
