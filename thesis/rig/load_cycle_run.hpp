#pragma once

// A run through the load cycle of Hubacher (2014), Section 7.5, as the studies of its figures judge it. The rig is
// deploy/robots/fc1d.yaml: its sensors are noisy, its integral factor is not the thesis's (7.11), its valve is probed.

#include <string>
#include <vector>

#include "control/model/discretise.hpp"
#include "trials/load_cycle.hpp"
#include "thesis/study/study.hpp"
#include "trace/trace.hpp"
#include "signals/signals.hpp"

namespace farrier::thesis {

struct CycleRun {
  trials::LoadCycle cycle;
  std::vector<trace::TraceRow> rows;
  std::vector<signals::JointControllerGains> gains;  ///< those of a stand, which act, in the order of their ticks
};

/// Runs a case; progress counts from `from` to `to`. Refuses as run::run_inproc does.
Result<CycleRun> run_cycle(const StudyContext& context, const trials::LoadCycleCase& one, double from = 0.0,
                           double to = 1.0);

/// Lambda of (6.21) in the adaptive case as the text has it.
inline constexpr double kPrintedForgetting = 0.9;

/// The adaptive case as the text has it: perfect measurements, no dither, the bare recursion (6.21) on deviations from
/// home, xi = 6, and no guard by the stored model. Refuses as run_cycle does.
Result<CycleRun> run_cycle_as_printed(const StudyContext& context, double forgetting_factor = kPrintedForgetting);

// Quarters count from 1.

/// RMS force error over RMS reference of a quarter without its transient.
double quarter_error(const CycleRun& run, std::size_t quarter);

/// The gains that act just before `tick`.
const signals::JointControllerGains& acting_before(const CycleRun& run, Tick tick);
const signals::JointControllerGains& at_end_of(const CycleRun& run, std::size_t quarter);

/// The model of the quarter's true load.
control::DiscreteModel truth_of(const CycleRun& run, std::size_t quarter);

/// "K = [0.1, -4.4, 8.5]".
std::string gains_text(const signals::JointControllerGains& gains);

}  // namespace farrier::thesis
