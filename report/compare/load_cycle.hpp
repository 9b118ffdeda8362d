#pragma once

// Hubacher (2014), Section 7.5, Figs 7.6 to 7.9: a rig whose load changes by quarters of the run.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "plant/actuator.hpp"
#include "trace/trace.hpp"
#include "robot/robot.hpp"
#include "signals/signals.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::report {

/// What happened to the load, as the report shows it.
struct LoadCyclePlan {
  const robot::Robot& robot;                 ///< with one joint
  std::array<plant::LoadParams, 4> loads;    ///< by quarter
  std::array<Tick, 5> begin;                 ///< of each quarter, and the end of the run
};

/// One run through the cycle.
struct LoadCycleRun {
  std::string name;    ///< as in the figures: "fixed", "adaptive", "true_load", "true_load_dithered",
                       ///< "greybox", "greybox_noiseless"
  std::string title;   ///< for people
  std::vector<trace::TraceRow> rows;
  std::vector<signals::JointControllerGains> gains;  ///< every update issued
};

inline constexpr double kFixedAtLeast = 1.0;        ///< heavy quarters: the light design does not hold the load
inline constexpr double kAdaptiveAtMost = 0.08;     ///< heavy quarters
inline constexpr double kGreyBoxAtMost = 0.08;      ///< every quarter, with the sensors' noise
inline constexpr double kNoiselessAtMost = 0.05;    ///< every quarter, without
inline constexpr double kLightRatioAtMost = 1.05;   ///< light quarters, LQR and least squares: adapting must not cost what it need not

/// trace::relative_error() of quarter 0..3 from trace::kJudgedAfter_s after its beginning.
double quarter_error(const LoadCyclePlan& plan, std::span<const trace::TraceRow> rows, std::size_t quarter) noexcept;

/// Adds trot.fig7_8.*: a figure per run and quarter, bounded as above from trace::kJudgedAfter_s on, ratios and the number of gain updates.
void add_load_cycle(Figures& figures, const LoadCyclePlan& plan, std::span<const LoadCycleRun> runs);

/// Draws every run's force and gains over time and the poles of its gains' models by quarter (Figs 7.7 to 7.9), writes
/// out_dir/index.html and returns its path. Refuses when gnuplot or the disk does.
Result<std::string> write_load_cycle_report(const std::string& out_dir, const Outcome& outcome,
                                            const LoadCyclePlan& plan, std::span<const LoadCycleRun> runs);

}  // namespace farrier::report
