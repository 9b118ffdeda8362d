#pragma once

// Changes of gains in the trials of a body, and how late they came after the feet.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::report {

/// Sums over the runs of a trial on hydraulic joints, falls included.
struct SwitchesResult {
  std::string trial;
  std::size_t runs = 0;
  std::size_t falls = 0;
  trials::GainSwitches switches{};
  trials::ForceErrors force_nrmse{};  ///< median of the runs without a fall; 0 if all fell

  /// Mean time from a touchdown to the gains of stance, of those that come too late, ms.
  double mean_late_ms() const noexcept;
};

/// A result per trial whose joints were told of a change of phase, in the order of trials::kTrotTrials.
std::vector<SwitchesResult> switches_results(std::span<const trials::TrotRow> rows);

/// Adds body.<trial>.planned_switches, felt_switches, late_touchdowns, mean_late_ms and largest_late_ms.
void add_switches(Figures& figures, std::span<const SwitchesResult> results);

/// A table with a line for every trial.
std::string switches_text(std::span<const SwitchesResult> results);

}  // namespace farrier::report
