#pragma once

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
  double residual_J() const noexcept {
    return pump_J - accumulator_J - relief_J - supply_leakage_J - valve_J - leakage_J - return_J - oil_J - friction_J -
           work_J;
  }

  /// The account between two instants.
  EnergyAudit operator-(const EnergyAudit& before) const noexcept {
    return {.pump_J = pump_J - before.pump_J,
            .accumulator_J = accumulator_J - before.accumulator_J,
            .relief_J = relief_J - before.relief_J,
            .supply_leakage_J = supply_leakage_J - before.supply_leakage_J,
            .valve_J = valve_J - before.valve_J,
            .leakage_J = leakage_J - before.leakage_J,
            .return_J = return_J - before.return_J,
            .oil_J = oil_J - before.oil_J,
            .friction_J = friction_J - before.friction_J,
            .work_J = work_J - before.work_J};
  }
};

}  // namespace farrier::world
