#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "run/inproc_run.hpp"
#include "robot/load_change.hpp"
#include "robot/robot.hpp"
#include "trace/trace.hpp"

namespace farrier::trials {

inline constexpr std::size_t kQuarters = 4;
inline constexpr double kQuarter_s = 1.0;       ///< Figs 7.7 and 7.8 are as long
inline constexpr double kLightMass_kg = 0.5;    ///< quarters 1 and 3, and what the first controller is for
inline constexpr double kHeavyMass_kg = 50.0;   ///< quarters 2 and 4
inline constexpr double kFrictionFactor = 5.0;  ///< of the load's friction, quarter 4

/// Hubacher (2014), Section 7.5 and Fig. 7.6: the load of a rig's joint changes by quarters of the run, and nothing
/// tells so. Quarter n begins at begin[n - 1] and ends where the next begins; the lead-in before the first has the
/// load of the first.
struct LoadCycle {
  robot::Robot robot;  ///< stands; swing load light, stance load heavy
  std::array<plant::LoadParams, kQuarters> loads;
  std::array<Tick, kQuarters + 1> begin;   ///< the last is the end of the run
  std::vector<robot::LoadChange> changes;  ///< of the world
};

/// The cycle on a robot with one joint. Refuses other robots, and a rig that cannot be built with these loads.
Result<LoadCycle> make_load_cycle(const robot::Robot& rig, double quarter_s = kQuarter_s);

/// A run through the cycle: what its gains are and whether the valve is probed.
struct LoadCycleCase {
  const char* name;   ///< "fixed"
  const char* title;  ///< for people
  supervisor::Design design;
  bool knows_loads;
  bool dithers;
  bool grey_box = false;   ///< with_grey_box() instead of linear gains
  bool noiseless = false;  ///< sensors without noise, and everybody knows it
};

inline constexpr LoadCycleCase kFixedCase{"fixed", "Gains fixed, designed for the light load",
                                          supervisor::Design::kSwing, false, false};
inline constexpr LoadCycleCase kAdaptiveCase{"adaptive", "Gains adaptive", supervisor::Design::kAdaptive, false, true};
inline constexpr LoadCycleCase kAdaptiveNoiselessCase{.name = "adaptive_noiseless",
                                                      .title = "Gains adaptive, no sensor noise",
                                                      .design = supervisor::Design::kAdaptive,
                                                      .knows_loads = false,
                                                      .dithers = true,
                                                      .noiseless = true};
inline constexpr LoadCycleCase kTrueLoadCase{"true_load", "Gains for the true load, switched exactly",
                                             supervisor::Design::kSwing, true, false};

inline constexpr LoadCycleCase kGreyBoxCase{.name = "greybox",
                                            .title = "Physics estimated, flow law inverted",
                                            .design = supervisor::Design::kAdaptive,
                                            .knows_loads = false,
                                            .dithers = false,
                                            .grey_box = true};
inline constexpr LoadCycleCase kGreyBoxNoiselessCase{.name = "greybox_noiseless",
                                                     .title = "Physics estimated, flow law inverted, no sensor noise",
                                                     .design = supervisor::Design::kAdaptive,
                                                     .knows_loads = false,
                                                     .dithers = false,
                                                     .grey_box = true,
                                                     .noiseless = true};

/// RMS force error over RMS reference (trace::relative_error) in quarter 0 to 3, from trace::kJudgedAfter_s after its
/// beginning.
double quarter_error(const LoadCycle& cycle, std::span<const trace::TraceRow> rows, std::size_t quarter) noexcept;

/// The robot of the case: with its dither, of its own or 0.1 % of the valve's nominal current, or without. The cycle's
/// reference alone excites nothing above 10 Hz.
robot::Robot robot_of(const LoadCycle& cycle, const LoadCycleCase& one);

/// Settings of the case's run; the trace's path and progress are the caller's.
run::InprocRun run_of(const LoadCycle& cycle, const LoadCycleCase& one, std::uint64_t seed);

}  // namespace farrier::trials
