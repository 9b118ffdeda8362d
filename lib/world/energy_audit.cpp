#include "world/energy_audit.hpp"

namespace farrier::world {

double EnergyAudit::residual_J() const noexcept {
  return pump_J - accumulator_J - relief_J - supply_leakage_J - valve_J - leakage_J - return_J - oil_J - friction_J -
         work_J;
}

EnergyAudit EnergyAudit::operator-(const EnergyAudit& before) const noexcept {
  EnergyAudit difference;
  for (const EnergyTerm& term : kEnergyTerms) {
    difference.*term.energy_J = this->*term.energy_J - before.*term.energy_J;
  }
  return difference;
}

}  // namespace farrier::world
