#pragma once

#include <cstdint>

namespace farrier::bench {

/// Cost of the grey-box estimator on one joint whose load changes every 250 ticks, ten- to a hundredfold.
struct GreyBoxBench {
  double take_s;             ///< wall time per GreyBoxEstimator::take, mean over all ticks, changes of load included
  double take_slowest_s;     ///< of the slowest tick in the fastest round: one after a change of load
  double estimate_s;         ///< per GreyBoxEstimator::estimate, standard errors and poles included
  std::int64_t allocations;  ///< of all this, -1 when they were not counted
};

/// Runs `ticks` (>= 250) of rich, full-range motion through it, ten times over; the fastest round counts.
/// `allocations_so_far` reads the program's counter of allocations; null where there is none.
GreyBoxBench bench_grey_box(int ticks, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
