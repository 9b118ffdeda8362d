#pragma once

// The account of the pump's work in the trial `energy`, and what half the step changes.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/figures/figures.hpp"
#include "trials/body/trot_trial.hpp"

namespace farrier::report {

/// Medians of runs.
struct StepMedians {
  double height_rms_mm = 0.0, tilt_rms_deg = 0.0, kfe_stance_nrmse = 0.0;
};

struct EnergyResult {
  std::size_t runs = 0;               ///< with the nominal step
  world::EnergyAudit mean;            ///< of these
  double residual_percent = 0.0;      ///< largest of them, of the pump's work
  StepMedians nominal;                ///< of these
  std::optional<StepMedians> halved;  ///< of the runs with half the step; none without such runs
};

/// Absent without runs of the trial `energy` on a pump.
std::optional<EnergyResult> energy_result(std::span<const trials::TrotRow> rows);

/// Adds body.energy.*: the terms, the residual with its bound, and the changes with half the step with theirs.
void add_energy(Figures& figures, const EnergyResult& result);

/// A line for every term, with its share of the pump's work, and for every change with half the step.
std::string energy_text(const EnergyResult& result);

}  // namespace farrier::report
