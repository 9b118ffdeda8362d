#pragma once

#include "config/visitor.hpp"

namespace farrier::robot {

// Sections of a robot file about electric actuators and their loads. The sentence, unit and range of every parameter
// are in the `declare` functions (electric_section.cpp); docs and checks come from there.

/// As Stops, about a joint.
struct RotaryStops {
  double stiffness_Nm_rad = 0.0;
  double damping_Nms_rad = 0.0;
};

struct RotaryNoise {
  double position_rad = 0.0;
  double velocity_rad_s = 0.0;
  double torque_Nm = 0.0;
};

/// Motor, gear, spring with the torque sensor.
struct ElectricActuator {
  double torque_constant_Nm_A = 0.0;
  double winding_resistance_Ohm = 0.0;
  double winding_inductance_H = 0.0;
  double supply_voltage_V = 0.0;
  double rotor_inertia_kg_m2 = 0.0;
  double gear_ratio = 0.0;
  double damping_Nms_rad = 0.0;
  double coulomb_Nm = 0.0;
  double slip_velocity_rad_s = 0.05;
  double spring_stiffness_Nm_rad = 0.0;
  double spring_damping_Nms_rad = 0.0;
  double travel_rad = 0.0;
  double rated_torque_Nm = 0.0;
  double velocity_norm_rad_s = 0.0;
  double torque_norm_Nm = 0.0;
  RotaryStops stops;
  RotaryNoise noise;
  config::Place place;
};

struct RotaryLoad {
  double inertia_kg_m2 = 0.0;
  double damping_Nms_rad = 0.0;
  double stiffness_Nm_rad = 0.0;
  double equilibrium_position_rad = 0.0;
};

/// Loads of an electric joint.
struct RotaryLoads {
  RotaryLoad swing;
  RotaryLoad stance;
};

void declare(config::Visitor& v, RotaryStops& stops);
void declare(config::Visitor& v, RotaryNoise& noise);
void declare(config::Visitor& v, ElectricActuator& actuator);
void declare(config::Visitor& v, RotaryLoad& load);
void declare(config::Visitor& v, RotaryLoads& loads);

}  // namespace farrier::robot
