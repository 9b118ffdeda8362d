#pragma once

// A run through the load cycle of Hubacher (2014), Section 7.5, as the studies of its figures judge it: as the text has
// it, or as Farrier does it. Both begin with the whole reference, as Fig. 7.8 does, without the robot file's lead-in. Farrier's rig is deploy/robots/fc1d.yaml: its sensors are noisy, its integral factor is not
// the thesis's (7.11), its valve is probed, and its supervisor refuses gains that the stored model does not bear.

#include <string>
#include <vector>

#include "control/design/closed_loop.hpp"
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

/// The run of 7.5 as the text has it.
struct PrintedCycle {
  bool adaptive = true;
  double forgetting_factor = 0.9;  ///< lambda of (6.21)
  double probing_percent = 0.0;    ///< of the nominal current: a random binary signal at the valve
};

/// The amplitude of Condition::kProbedValve.
inline constexpr double kProbing_percent = 0.25;

/// Gains of the cycle's robot for a load, designed as the text does on (3.51), which neglects the piston's mass. Refuses
/// where there is no design.
Result<control::Gains> printed_gains(const robot::Robot& robot, const plant::LoadParams& load);

/// The cycle as the text has it: perfect measurements, xi = 6, the bare recursion (6.21) on deviations from home, update
/// logic (d). The first gains are those of the light load by (3.51). There is no guard: neither margins nor the stored
/// model refuse gains. Refuses as run_cycle does.
Result<CycleRun> run_cycle_as_printed(const StudyContext& context, const PrintedCycle& printed = {}, double from = 0.0,
                                      double to = 1.0);

// Quarters count from 1.

/// RMS force error over RMS reference of a quarter without its transient.
double quarter_error(const CycleRun& run, std::size_t quarter);

/// RMS force error over RMS reference in the period of the reference's highest frequency that begins at `tick`.
double error_from(const CycleRun& run, Tick tick);
/// Lag (degrees) of the force behind the reference at the reference's highest frequency in a quarter without its
/// transient. The sines of the reference are fitted to both by least squares.
double quarter_lag_deg(const CycleRun& run, std::size_t quarter);
/// Largest force over the largest reference in a quarter without its transient, less 1.
double quarter_overshoot(const CycleRun& run, std::size_t quarter);

/// The gains that act just before `tick`.
const signals::JointControllerGains& acting_before(const CycleRun& run, Tick tick);
const signals::JointControllerGains& at_end_of(const CycleRun& run, std::size_t quarter);

/// The model of the quarter's true load.
control::DiscreteModel truth_of(const CycleRun& run, std::size_t quarter);

/// Force and gains over time. The force is cut at twice the reference; the panel's title says how far it goes.
Picture force_picture(const CycleRun& run, const std::string& caption);

/// "K = [0.1, -4.4, 8.5]".
std::string gains_text(const signals::JointControllerGains& gains);

}  // namespace farrier::thesis
