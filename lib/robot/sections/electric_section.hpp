#pragma once

#include <optional>

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

/// Motor and gear, with the spring in which the torque sensor sits or rigid. A drive known only by its limits, as in a
/// URDF, is rigid too. `declare` checks that the keys of one of the three kinds are all there.
struct ElectricActuator {
  std::optional<double> torque_limit_Nm = {};
  std::optional<double> speed_limit_rad_s = {};
  std::optional<double> armature_kg_m2 = {};
  std::optional<double> torque_constant_Nm_A = {};
  std::optional<double> winding_resistance_Ohm = {};
  std::optional<double> winding_inductance_H = {};
  std::optional<double> supply_voltage_V = {};
  std::optional<double> rotor_inertia_kg_m2 = {};
  std::optional<double> gear_ratio = {};
  double damping_Nms_rad = 0.0;
  double coulomb_Nm = 0.0;
  double slip_velocity_rad_s = 0.05;
  std::optional<double> spring_stiffness_Nm_rad = {};
  double spring_damping_Nms_rad = 0.0;
  double torque_time_constant_s = 1e-3;
  double travel_rad = 0.0;
  std::optional<double> rated_torque_Nm = {};
  std::optional<double> velocity_norm_rad_s = {};
  std::optional<double> torque_norm_Nm = {};
  std::optional<RotaryStops> stops = {};
  std::optional<RotaryNoise> noise = {};
  config::Place place;

  /// True if the joint is known by its limits alone.
  bool by_limits() const noexcept { return torque_limit_Nm || speed_limit_rad_s || armature_kg_m2; }
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
