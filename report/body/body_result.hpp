#pragma once

// Result of `farrier trial body`: a row for every run, judged trial by trial.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/figures.hpp"
#include "trials/body/push_limit.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::report {

/// The worst of all runs of a trial, in the units of its figures. Means are those of runs without a fall.
struct BodyTrialResult {
  std::string trial;
  std::size_t runs = 0;
  std::size_t falls = 0;
  double height_rms_mm = 0.0, height_offset_mm = 0.0, sag_mm = 0.0;
  std::optional<double> loaded_sag_mm;  ///< from 2 s after a load is put on; none without a load
  double tilt_rms_deg = 0.0;
  double speed_error_percent = 0.0;
  std::optional<double> odometry_error_percent;  ///< none if no run went 1 m
  double heading_drift_deg_min = 0.0;
  std::optional<double> lateral_drift_m_min;  ///< none where no run follows a line
  double largest_torque_Nm = 0.0;
  trials::ForceErrors force_nrmse{};
  double energy_error_percent = 0.0;
  std::optional<double> least_supply_bar, mean_flow_l_min, energy_J_m;  ///< none where no pump is simulated

  double upright_share() const noexcept;
};

/// Calls visit(place, phase, "<place>.<phase>") for every entry of trials::ForceErrors.
template <class Visit>
void for_each_force_error(Visit visit) {
  constexpr std::array<const char*, body::kJointsPerLeg> kPlaces{"haa", "hfe", "kfe"};
  constexpr std::array<const char*, kPhaseCount> kPhases{"swing", "stance"};
  for (std::size_t place = 0; place < kPlaces.size(); ++place) {
    for (std::size_t phase = 0; phase < kPhases.size(); ++phase) {
      visit(place, phase, std::string(kPlaces[place]) + "." + kPhases[phase]);
    }
  }
}

/// A result per trial that has rows, in the order of trials::kTrotTrials.
std::vector<BodyTrialResult> body_results(std::span<const trials::TrotRow> rows);

/// Adds body.push_limit.<side>_Ns, without a bound, of the sides where half of the pushes fell at some tested impulse.
void add_push_limits(Figures& figures, std::span<const trials::PushLimit> limits);

/// A line for every side. One with no such impulse says up to which there is none.
std::string push_limits_text(std::span<const trials::PushLimit> limits);

/// A line for every run of the results that ended with a fall, with instant and reason, but for those of push_limit.
std::string falls_text(std::span<const trials::TrotRow> rows);

/// Adds body.<trial>.*, with the bounds of the trial.
void add_body(Figures& figures, std::span<const BodyTrialResult> results);

/// The table of verdicts for people: "pass" if every bound of the trial's figures holds, "-" for a trial without bounds.
std::string body_text(const Figures& figures, std::span<const BodyTrialResult> results);

/// Every run as CSV with a header line. Refuses if the disk does not take all of it.
Result<Done> write_body_csv(const std::string& path, std::span<const trials::TrotRow> rows);

}  // namespace farrier::report
