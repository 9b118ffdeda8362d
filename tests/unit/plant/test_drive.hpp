#pragma once

#include "plant/electric_actuator.hpp"

namespace farrier::plant::test {

/// The drive of deploy/robots/electric_leg.yaml.
inline ElectricParams drive() {
  return {.torque_constant_Nm_A = 0.1,
          .winding_resistance_Ohm = 0.16,
          .winding_inductance_H = 3.2e-5,
          .supply_voltage_V = 48.0,
          .rotor_inertia_kg_m2 = 3.4e-5,
          .gear_ratio = 50.0,
          .damping = 5.0,
          .coulomb = 2.0,
          .slip_velocity = 0.05,
          .spring_stiffness = 1e4,
          .spring_damping = 5.0,
          .travel = 2.6,
          .stop_stiffness = 1e5,
          .stop_damping = 50.0};
}

}  // namespace farrier::plant::test
