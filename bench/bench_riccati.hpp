#pragma once

namespace farrier::bench {

/// Mean wall time and worst relative residual of three solvers of the Riccati equation (7.4), each run to a relative
/// residual of 1e-12 where it can be told to.
struct RiccatiBench {
  double doubling_s;          ///< per equation: structured doubling, control::solve_dare
  double iteration_s;         ///< per equation: the thesis's (8.1), control::solve_dare_by_iteration
  double slicot_s;            ///< per equation: SLICOT's SB02OD; NaN when built without SLICOT
  double doubling_residual;   ///< worst of the set; NaN when an equation was refused
  double iteration_residual;
  double slicot_residual;     ///< SB02OD has no tolerance to set: what it gives
};

/// Runs every equation of the set `repetitions` (>= 1) times per solver: FC1D in swing, stance and three loads in
/// between, full-state and compliant; HyQ likewise, compliant. The smallest of twenty means is reported.
RiccatiBench bench_riccati(int repetitions);

}  // namespace farrier::bench
