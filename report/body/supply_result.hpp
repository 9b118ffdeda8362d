#pragma once

// Figures of trials with a fault of the supply or of an actuator.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::report {

/// The worst of all runs of a trial. Seconds are since the fault.
struct SupplyTrialResult {
  std::string trial;
  std::size_t runs = 0;
  std::size_t slowed = 0;          ///< runs in which locomotion trotted more slowly for it
  std::size_t acted = 0;           ///< runs in which locomotion stood or lay down for it
  std::size_t unnoticed_sags = 0;  ///< runs with 20 mm of sag before the supply was low
  std::size_t not_lying = 0;       ///< runs that never lay
  std::size_t not_recovered = 0;   ///< runs that end with less pressure than that from which on a trot slows down
  std::size_t hard_landings = 0;   ///< runs that fell, never lay, or sank at 0.5 m/s or more
  std::optional<double> slows_s;   ///< the earliest
  std::optional<double> low_s;     ///< the latest; none if it never was low
  std::optional<double> sag_s;     ///< the earliest
  std::optional<double> acts_s;    ///< the earliest
  std::optional<double> lying_s;   ///< the latest
  double sinking_m_s = 0.0, foot_force_N = 0.0;
  double end_speed_m_s = 0.0;  ///< mean of the runs
};

/// A result per trial that has a fault of the supply or of an actuator, in the order of trials::kTrotTrials.
std::vector<SupplyTrialResult> supply_results(std::span<const trials::TrotRow> rows);

/// Adds body.<trial>.* of them, with bounds: `supply` goes on, `low_supply` goes on more slowly,
/// `pump_stops` ends lying, trials that are marked so land softly in seven of eight runs.
void add_supply(Figures& figures, std::span<const SupplyTrialResult> results);

/// A line for every trial.
std::string supply_text(std::span<const SupplyTrialResult> results);

}  // namespace farrier::report
