#pragma once

#include <array>

namespace farrier::world {

/// Where the work of the pump has gone, J; all since one instant.
struct EnergyAudit {
  double pump_J = 0.0;            ///< pressure of the supply times flow of the pump
  double accumulator_J = 0.0;     ///< gained by accumulator and hoses, and taken away with an accumulator that was lost
  double relief_J = 0.0;          ///< spilled
  double supply_leakage_J = 0.0;  ///< past shut valves
  double valve_J = 0.0;           ///< lost in open ports
  double leakage_J = 0.0;         ///< lost past lands, pistons and in lines
  double return_J = 0.0;          ///< given to the return line
  double oil_J = 0.0;             ///< gained by the oil of the actuators, which is compressed
  double friction_J = 0.0;        ///< of pistons and their seals
  double work_J = 0.0;            ///< done on the body: sum of force times displacement really made

  /// Work of the pump that the other terms do not find again.
  double residual_J() const noexcept;

  /// The account between two instants.
  EnergyAudit operator-(const EnergyAudit& before) const noexcept;
};

/// A term of the account.
struct EnergyTerm {
  const char* name;      ///< as its field is called
  const char* sentence;  ///< for people
  double EnergyAudit::*energy_J;
};

/// The pump first, then where its work has gone.
inline constexpr std::array kEnergyTerms{
    EnergyTerm{"pump_J", "pump", &EnergyAudit::pump_J},
    EnergyTerm{"relief_J", "relief valve", &EnergyAudit::relief_J},
    EnergyTerm{"supply_leakage_J", "leakage of shut valves", &EnergyAudit::supply_leakage_J},
    EnergyTerm{"accumulator_J", "gained by the accumulator", &EnergyAudit::accumulator_J},
    EnergyTerm{"valve_J", "open valves", &EnergyAudit::valve_J},
    EnergyTerm{"leakage_J", "leakage of the actuators", &EnergyAudit::leakage_J},
    EnergyTerm{"return_J", "return line", &EnergyAudit::return_J},
    EnergyTerm{"oil_J", "gained by compressed oil", &EnergyAudit::oil_J},
    EnergyTerm{"friction_J", "friction", &EnergyAudit::friction_J},
    EnergyTerm{"work_J", "work on the body", &EnergyAudit::work_J}};

/// The account in a sample that has a field per term.
template <class Sample>
EnergyAudit audit_in(const Sample& sample) noexcept {
  return {.pump_J = sample.pump_J,
          .accumulator_J = sample.accumulator_J,
          .relief_J = sample.relief_J,
          .supply_leakage_J = sample.supply_leakage_J,
          .valve_J = sample.valve_J,
          .leakage_J = sample.leakage_J,
          .return_J = sample.return_J,
          .oil_J = sample.oil_J,
          .friction_J = sample.friction_J,
          .work_J = sample.work_J};
}

/// Puts an account into such a sample.
template <class Sample>
void put(const EnergyAudit& audit, Sample& sample) noexcept {
  sample.pump_J = audit.pump_J;
  sample.accumulator_J = audit.accumulator_J;
  sample.relief_J = audit.relief_J;
  sample.supply_leakage_J = audit.supply_leakage_J;
  sample.valve_J = audit.valve_J;
  sample.leakage_J = audit.leakage_J;
  sample.return_J = audit.return_J;
  sample.oil_J = audit.oil_J;
  sample.friction_J = audit.friction_J;
  sample.work_J = audit.work_J;
}

}  // namespace farrier::world
