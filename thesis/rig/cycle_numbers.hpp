#pragma once

// Numbers of an adaptive run through the load cycle of Hubacher (2014), Section 7.5, that the claims of Fig. 7.8 are about.

#include <limits>

#include "thesis/rig/load_cycle_run.hpp"

namespace farrier::thesis {

/// Gains for the true load of a quarter while the valve extends the piston, and while it retracts it.
struct TrueGains {
  control::Gains extending, retracting;
};

/// Refuses a load without a design.
Result<TrueGains> true_gains(const robot::Robot& robot, const plant::LoadParams& load);

/// Numbers of an adaptive run that the claims are about.
struct CycleNumbers {
  double error[trials::kQuarters], improvement[trials::kQuarters];
  double first_update_s = -1.0, settled_s = 0.0;
  double at_once =
      std::numeric_limits<double>::quiet_NaN();  ///< error after the first new gains over that without them
  double second_lag_deg = 0.0, second_overshoot = 0.0;
  signals::JointControllerGains second, third, fourth;  ///< that act at the quarter's end
};

/// `fixed` is the same run with the first gains kept. Refuses as true_gains does.
Result<CycleNumbers> numbers_of(const CycleRun& run, const CycleRun& fixed);

}  // namespace farrier::thesis
