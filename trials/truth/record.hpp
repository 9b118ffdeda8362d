#pragma once

#include "trials/truth/hide.hpp"
#include "trials/truth/truth.hpp"

namespace farrier::truth {

/// The joint's machine: every number of its file, but for the ends of stroke and spring, is off by 1 to 2 %, up or
/// down by seed.
Machine machine_of(const robot::Joint& joint, std::uint64_t seed);

/// Largest and lowest values in a run.
struct Went {
  double peak_current_A = 0.0, peak_flow_m3_s = 0.0;
  double excursion = 0.0, stretch = 0.0;    ///< of the load, largest
  double peak_force = 0.0;                  ///< of the chambers, N or Nm
  double lowest_Pa = 0.0;                   ///< of either chamber
  double rms_force = 0.0, rms_motion = 0.0;
  bool finite = true;
};

struct Run {
  Samples samples;
  Went went;
};

/// Runge-Kutta steps per tick that this machine is recorded with; README.md has what twice as many change.
int step_count(const Machine& machine, double period_s);

/// One run of the plan with this machine. `scale` is the excitation's, `substeps` as of Clock.
Run record(const robot::Joint& joint, double period_s, const Plan& plan, const Machine& machine, double scale,
           int substeps);

}  // namespace farrier::truth
