#pragma once

#include <array>
#include <cstdint>

namespace farrier::bench {

/// Cost of one tick of one joint's estimator, by method.
struct EstimatorsBench {
  struct Method {
    const char* name;  ///< as in a robot file
    double take_s;     ///< wall time per JointEstimator::take, four regressors
  };
  std::array<Method, 6> methods;
  double pe_s;               ///< what the gate of that name adds, with rls
  double fft_s;
  std::int64_t allocations;  ///< of all these ticks, -1 when they were not counted
};

/// Runs `ticks` (>= 200, so that the washout settles) of dither and noise through each, twenty times over; the fastest round counts.
/// `allocations_so_far` reads the program's counter of allocations; null where there is none.
EstimatorsBench bench_estimators(int ticks, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
