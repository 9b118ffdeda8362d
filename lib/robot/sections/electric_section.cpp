#include "robot/sections/electric_section.hpp"

namespace farrier::robot {

using config::kInitial;
using config::Visitor;

void declare(Visitor& v, RotaryStops& stops) {
  v.number("stiffness_Nm_rad", stops.stiffness_Nm_rad, {1, 1e8}, "Stiffness of the contact with an end of the travel.");
  v.number("damping_Nms_rad", stops.damping_Nms_rad, {0, 1e6}, "Damping of that contact.");
}

void declare(Visitor& v, RotaryNoise& noise) {
  v.number("position_rad", noise.position_rad, {0, 0.1}, "Standard deviation of the measured position.");
  v.number("velocity_rad_s", noise.velocity_rad_s, {0, 10}, "Standard deviation of the measured velocity.");
  v.number("torque_Nm", noise.torque_Nm, {0, 100}, "Standard deviation of the torque sensor.");
}

void declare(Visitor& v, ElectricActuator& a) {
  v.here(a.place);
  v.number(
      "torque_limit_Nm", a.torque_limit_Nm, {1e-2, 1e5},
      "Largest torque of a joint known by its limits, a URDF's effort; with speed_limit_rad_s and armature_kg_m2 it "
      "takes the place of the motor's values.");
  v.number("speed_limit_rad_s", a.speed_limit_rad_s, {1e-2, 1e3},
           "Largest speed of such a joint, a URDF's velocity; the drive gives no torque beyond 1.05 of it.");
  v.number("armature_kg_m2", a.armature_kg_m2, {0, 100}, "Rotor of such a joint, as its output feels it.");
  v.number("torque_constant_Nm_A", a.torque_constant_Nm_A, {1e-4, 10},
           "Torque of the rotor per current, K; also its back-EMF per speed.");
  v.number("winding_resistance_Ohm", a.winding_resistance_Ohm, {1e-3, 100}, "Of the winding, R.");
  v.number("winding_inductance_H", a.winding_inductance_H, {1e-7, 1},
           "Of the winding, L; a drive without a spring does not need it.");
  v.number("supply_voltage_V", a.supply_voltage_V, {1, 1000},
           "Largest voltage of the drive, V_max; commands are currents up to V_max / R.");
  v.number("rotor_inertia_kg_m2", a.rotor_inertia_kg_m2, {1e-9, 1}, "Rotor and what turns with it, J.");
  v.number("gear_ratio", a.gear_ratio, {1, 1000}, "Turns of the rotor per turn of the output, N.");
  v.number("damping_Nms_rad", a.damping_Nms_rad, {0, 1e4}, kInitial,
           "Viscous friction of rotor and gear, at the output, d_r.");
  v.number("coulomb_Nm", a.coulomb_Nm, {0, 1e3}, kInitial, "Dry friction of rotor and gear, at the output, T_c.");
  v.number("slip_velocity_rad_s", a.slip_velocity_rad_s, {1e-4, 10}, kInitial,
           "Speed of the output at which dry friction has 0.7 of its size.");
  v.number("spring_stiffness_Nm_rad", a.spring_stiffness_Nm_rad, {1, 1e7},
           "Spring between gear and load with the torque sensor, k; without it the drive is rigid.");
  v.number("spring_damping_Nms_rad", a.spring_damping_Nms_rad, {0, 1e3}, kInitial, "Its damping, b.");
  v.number("torque_time_constant_s", a.torque_time_constant_s, {1e-4, 0.02}, kInitial,
           "Time constant with which the torque of a rigid drive follows its command.");
  v.number("travel_rad", a.travel_rad, {1e-2, 100}, "Angle from stop to stop.");
  v.number("rated_torque_Nm", a.rated_torque_Nm, {1e-2, 1e5},
           "Torque the gear and the spring are made for; without it the largest one of the drive.");
  v.number("velocity_norm_rad_s", a.velocity_norm_rad_s, {1e-3, 1e3},
           "Velocity that counts as 1 (3.52); without it the no-load speed.");
  v.number("torque_norm_Nm", a.torque_norm_Nm, {1e-2, 1e5},
           "Torque that counts as 1 (3.52); without it the rated torque.");
  v.group(
      "stops", a.stops,
      "Contact of the load at both ends of the travel; without it one that the largest torque presses in by 0.5 %.");
  v.group("noise", a.noise, "Sensor noise; without it 1e-5 rad, 2e-3 rad/s and a thousandth of the rated torque.");
  const std::string by_limits =
      "give torque_limit_Nm, speed_limit_rad_s and armature_kg_m2 of a joint known by its limits, as a URDF has them, "
      "or "
      "torque_constant_Nm_A, winding_resistance_Ohm, supply_voltage_V, rotor_inertia_kg_m2 and gear_ratio of its motor";
  const bool any_of_motor = a.torque_constant_Nm_A || a.winding_resistance_Ohm || a.winding_inductance_H ||
                            a.supply_voltage_V || a.rotor_inertia_kg_m2 || a.gear_ratio || a.spring_stiffness_Nm_rad;
  const bool motor =
      a.torque_constant_Nm_A && a.winding_resistance_Ohm && a.supply_voltage_V && a.rotor_inertia_kg_m2 && a.gear_ratio;
  const bool limits = a.torque_limit_Nm && a.speed_limit_rad_s && a.armature_kg_m2;
  v.check(!a.by_limits() || !any_of_motor, "", "has limits and a motor's values: " + by_limits);
  v.check(a.by_limits() ? limits : motor, "", "lacks values: " + by_limits);
  v.check(!a.spring_stiffness_Nm_rad || !motor || a.winding_inductance_H, "winding_inductance_H",
          "is missing: a drive with a spring needs it");
}

void declare(Visitor& v, RotaryLoad& l) {
  v.number("inertia_kg_m2", l.inertia_kg_m2, {1e-5, 1e3}, "Inertia the joint moves, m_l.");
  v.number("damping_Nms_rad", l.damping_Nms_rad, {0, 1e4}, "Viscous friction of the load, d_l.");
  v.number("stiffness_Nm_rad", l.stiffness_Nm_rad, {0, 1e6}, kInitial, "Springs against the base, C.");
  v.number("equilibrium_position_rad", l.equilibrium_position_rad, {-10, 10}, kInitial,
           "Actuator position where those are slack.");
}

void declare(Visitor& v, RotaryLoads& l) {
  v.group("swing", l.swing, "With the leg in the air.");
  v.group("stance", l.stance, "With the foot on the ground.");
}

}  // namespace farrier::robot
