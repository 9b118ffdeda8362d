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

/// A term of the account.
struct EnergyTerm {
  const char* name;
  const char* sentence;
  double world::EnergyAudit::*energy_J;
};

inline constexpr std::array kEnergyTerms{
    EnergyTerm{"pump_J", "pump", &world::EnergyAudit::pump_J},
    EnergyTerm{"relief_J", "relief valve", &world::EnergyAudit::relief_J},
    EnergyTerm{"supply_leakage_J", "leakage of shut valves", &world::EnergyAudit::supply_leakage_J},
    EnergyTerm{"accumulator_J", "gained by the accumulator", &world::EnergyAudit::accumulator_J},
    EnergyTerm{"valve_J", "open valves", &world::EnergyAudit::valve_J},
    EnergyTerm{"leakage_J", "leakage of the actuators", &world::EnergyAudit::leakage_J},
    EnergyTerm{"return_J", "return line", &world::EnergyAudit::return_J},
    EnergyTerm{"oil_J", "gained by compressed oil", &world::EnergyAudit::oil_J},
    EnergyTerm{"friction_J", "friction", &world::EnergyAudit::friction_J},
    EnergyTerm{"work_J", "work on the body", &world::EnergyAudit::work_J}};

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
