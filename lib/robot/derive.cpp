#include "robot/derive.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "core/text.hpp"

namespace farrier::robot {
namespace {

plant::ActuatorParams common_params(const Supply& supply, const Valve& valve, const Actuator& actuator) {
  plant::ActuatorParams params;
  params.line_volume_m3 = actuator.line_volume_m3;
  params.bulk_modulus_Pa = supply.bulk_modulus_Pa;
  params.valve_gain = valve.gain_m3_s_AsqrtPa;
  params.valve_current_max_A = valve.current_max_A;
  params.supply_pressure_Pa = supply.supply_pressure_Pa;
  params.return_pressure_Pa = supply.return_pressure_Pa;
  params.laminar_pressure_Pa = supply.laminar_pressure_Pa;
  if (actuator.lines) {
    const LineSection& line = *actuator.lines;
    params.line = {line.length_m, line.bore_m, line.density_kg_m3, line.viscosity_Pa_s, line.loss_coefficient};
  }
  return params;
}

// A joint known by its limits is a motor with K = N = 1, whose voltage lets the torque fall from its limit at the largest
// speed to nothing at 1.05 of it.
void set_motor(plant::ElectricParams& params, const ElectricActuator& a) {
  constexpr double kFade = 0.05;
  params.torque_constant_Nm_A = a.torque_constant_Nm_A.value_or(1.0);
  params.gear_ratio = a.gear_ratio.value_or(1.0);
  params.winding_inductance_H = a.winding_inductance_H.value_or(0.0);
  if (a.by_limits()) {
    params.rigid = true;
    params.rotor_inertia_kg_m2 = *a.armature_kg_m2;
    params.current_limit_A = *a.torque_limit_Nm;
    params.winding_resistance_Ohm = kFade * *a.speed_limit_rad_s / *a.torque_limit_Nm;
    params.supply_voltage_V = (1.0 + kFade) * *a.speed_limit_rad_s;
    return;
  }
  params.winding_resistance_Ohm = *a.winding_resistance_Ohm;
  params.supply_voltage_V = *a.supply_voltage_V;
  params.rotor_inertia_kg_m2 = *a.rotor_inertia_kg_m2;
  params.rigid = !a.spring_stiffness_Nm_rad || spring_is_rigid(a);
}

// Stops that the largest torque presses in by half of what plant::validate allows, and that take it up at full speed.
RotaryStops usual_stops(const plant::ElectricParams& params) {
  return {.stiffness_Nm_rad = 200.0 * plant::stall_torque(params) / params.travel,
          .damping_Nms_rad = plant::stall_torque(params) / plant::no_load_speed(params)};
}

/// The fields of a hydraulic actuator that code for both kinds of joint reads: travel and largest current. The rest is
/// 0.
plant::ActuatorParams limits_of_electric(const plant::ElectricParams& electric) {
  plant::ActuatorParams limits;
  limits.stroke = electric.travel;
  limits.valve_current_max_A = plant::current_max_A(electric);
  return limits;
}

plant::LoadParams rotary_load(const RotaryLoad& load) {
  return {load.inertia_kg_m2, load.damping_Nms_rad, load.stiffness_Nm_rad, load.equilibrium_position_rad, {}};
}

}  // namespace

plant::ElectricParams electric_params(const ElectricActuator& a) {
  plant::ElectricParams params{.damping = a.damping_Nms_rad,
                               .coulomb = a.coulomb_Nm,
                               .slip_velocity = a.slip_velocity_rad_s,
                               .spring_stiffness = a.spring_stiffness_Nm_rad.value_or(0.0),
                               .spring_damping = a.spring_damping_Nms_rad,
                               .travel = a.travel_rad,
                               .torque_time_constant_s = a.torque_time_constant_s};
  set_motor(params, a);
  const RotaryStops stops = a.stops.value_or(usual_stops(params));
  params.stop_stiffness = stops.stiffness_Nm_rad;
  params.stop_damping = stops.damping_Nms_rad;
  return params;
}

SpringLimits spring_limits(const ElectricActuator& a) {
  const plant::ElectricParams motor{.torque_constant_Nm_A = *a.torque_constant_Nm_A,
                                    .winding_resistance_Ohm = *a.winding_resistance_Ohm,
                                    .rotor_inertia_kg_m2 = *a.rotor_inertia_kg_m2,
                                    .gear_ratio = *a.gear_ratio,
                                    .damping = a.damping_Nms_rad};
  return {plant::stiffest_spring_Nm_rad(motor), plant::softest_rigid_spring_Nm_rad(motor)};
}

bool spring_is_rigid(const ElectricActuator& a) {
  if (a.by_limits() || !a.spring_stiffness_Nm_rad) {
    return false;
  }
  const auto [stiffest, softest_rigid] = spring_limits(a);
  return *a.spring_stiffness_Nm_rad > stiffest && *a.spring_stiffness_Nm_rad >= softest_rigid;
}

std::string rigid_spring_note(const RobotFile& file) {
  std::vector<std::string> names;
  for (const auto& [name, actuator] : file.electric_actuators) {
    if (spring_is_rigid(actuator)) {
      names.push_back(name);
    }
  }
  return names.empty() ? ""
                       : "rotors oscillate above 100 Hz on the springs of " + join(names, ", ") +
                             ": these drives count as rigid, and their torque is known from the current";
}

double rated_torque_Nm(const ElectricActuator& a) {
  return a.rated_torque_Nm.value_or(plant::stall_torque(electric_params(a)));
}

Result<plant::Linkage> make_linkage(const LinkageSection& section, bool mirrored) {
  const double mirror = mirrored ? -1.0 : 1.0;
  if (section.direct) {
    // lever (-q - zero) = -lever (q - (-zero))
    return plant::Linkage::direct(mirror * section.direct->lever, mirror * section.direct->zero_angle_rad);
  }
  const Triangle& t = *section.triangle;
  return plant::Linkage::triangle({.side_a_m = t.side_a_m,
                                   .side_b_m = t.side_b_m,
                                   .angle_at_zero_rad = t.angle_at_zero_rad,
                                   .angle_sign = t.opens_with_angle ? 1.0 : -1.0,
                                   .mirror = mirror,
                                   .retracted_length_m = t.retracted_length_m});
}

plant::ActuatorParams cylinder_params(const Supply& supply, const Valve& valve, const Actuator& actuator) {
  const Cylinder& c = *actuator.cylinder;
  plant::ActuatorParams params = common_params(supply, valve, actuator);
  params.area_a = std::numbers::pi / 4.0 * c.bore_m * c.bore_m;
  params.area_b = std::numbers::pi / 4.0 * (c.bore_m * c.bore_m - c.rod_m * c.rod_m);
  params.stroke = c.stroke_m;
  params.piston_mass = c.piston_mass_kg;
  params.piston_damping = c.piston_damping_Ns_m;
  params.stop_stiffness = c.stops.stiffness_N_m;
  params.stop_damping = c.stops.damping_Ns_m;
  return params;
}

plant::ActuatorParams motor_params(const Supply& supply, const Valve& valve, const Actuator& actuator,
                                   const Cylinder& like, double lever_m) {
  const double square = lever_m * lever_m;
  plant::ActuatorParams params = common_params(supply, valve, actuator);
  params.area_a = actuator.rotary_motor->displacement_m3_rad;
  params.area_b = params.area_a;
  params.stroke = actuator.rotary_motor->travel_rad;
  params.piston_mass = like.piston_mass_kg * square;
  params.piston_damping = like.piston_damping_Ns_m * square;
  params.stop_stiffness = like.stops.stiffness_N_m * square;
  params.stop_damping = like.stops.damping_Ns_m * square;
  return params;
}

plant::LoadParams cylinder_load(const CylinderLoad& load) {
  return {load.mass_kg, load.damping_Ns_m, load.stiffness_N_m, load.equilibrium_position_m, {}};
}

plant::LoadParams leg_load(double inertia_kg_m2, const CylinderLoad& damping_like, double lever_m) {
  return {inertia_kg_m2, damping_like.damping_Ns_m * lever_m * lever_m, 0.0, 0.0, {}};
}

std::optional<plant::SupplyParams> supply_params(const RobotFile& file) {
  const std::optional<Supply>& supply = file.supply;
  if (!supply || !supply->pump) {
    return std::nullopt;
  }
  double valves = 0.0;
  for (const auto& [leg_name, leg] : file.legs) {
    for (const auto& [joint_name, kind] : leg.joints) {
      valves += electric_actuator_of(file, *config::find(file.joints, kind)) == nullptr ? 1.0 : 0.0;
    }
  }
  const Accumulator accumulator = supply->accumulator.value_or(Accumulator{});
  return plant::SupplyParams{.relief_pressure_Pa = supply->supply_pressure_Pa,
                             .return_pressure_Pa = supply->return_pressure_Pa,
                             .pump_flow_m3_s = supply->pump->flow_m3_s,
                             .accumulator_volume_m3 = accumulator.volume_m3,
                             .precharge_Pa = accumulator.precharge_Pa,
                             .polytropic_exponent = accumulator.polytropic_exponent,
                             .compliance_m3_Pa = supply->pump->hose_compliance_m3_Pa,
                             .null_leakage_m3_s_Pa = supply->pump->null_leakage_m3_s_Pa * valves};
}

std::optional<locomotion::SupplyGuardParams> supply_guard_params(const RobotFile& file) {
  constexpr double kStopped = 0.05;  // of the pump's flow
  const std::optional<Supply>& supply = file.supply;
  if (!supply || !supply->pump) {
    return std::nullopt;
  }
  return locomotion::SupplyGuardParams{.low_Pa = supply->low_share * supply->supply_pressure_Pa,
                                       .slow_Pa = supply->slow_share * supply->supply_pressure_Pa,
                                       .recovered_Pa = supply->recovered_share * supply->supply_pressure_Pa,
                                       .lie_Pa = supply->lie_share * supply->supply_pressure_Pa,
                                       .least_pump_flow_m3_s = kStopped * supply->pump->flow_m3_s,
                                       .stand_after_s = supply->stand_after_s,
                                       .slowest = supply->slowest};
}

ForceLimits force_limits(const plant::ActuatorParams& a, double rated) {
  return {std::min(rated, a.supply_pressure_Pa * a.area_a - a.return_pressure_Pa * a.area_b),
          std::min(rated, a.supply_pressure_Pa * a.area_b - a.return_pressure_Pa * a.area_a)};
}

SensorNoise cylinder_noise(const CylinderNoise& noise) { return {noise.position_m, noise.velocity_m_s, noise.force_N}; }

SensorNoise motor_noise(const CylinderNoise& noise, double lever_m) {
  return {noise.position_m / lever_m, noise.velocity_m_s / lever_m, noise.force_N * lever_m};
}

Sensors sensors(const std::optional<SensorSection>& section, double lever) {
  if (!section) {
    return {};
  }
  const auto low_pass = [&](double cut_off_Hz) {
    return control::LowPassParams{cut_off_Hz, section->filter_order, section->filter_damping};
  };
  return {.position = low_pass(section->position_filter_Hz),
          .velocity = low_pass(section->velocity_filter_Hz),
          .force = low_pass(section->force_filter_Hz),
          .anti_alias = {.cut_off_Hz = section->anti_alias_Hz},
          .oversampling = section->oversampling,
          .position_step = section->position_step_m / lever};
}

control::Normalisation cylinder_normalisation(const Cylinder& cylinder, const plant::ActuatorParams& params) {
  return {0.5 * params.stroke, cylinder.velocity_norm_m_s, cylinder.force_norm_N, params.valve_current_max_A};
}

control::Normalisation motor_normalisation(const Cylinder& like, const plant::ActuatorParams& params, double lever_m) {
  return {0.5 * params.stroke, like.velocity_norm_m_s / lever_m, like.force_norm_N * lever_m,
          params.valve_current_max_A};
}

void drive_electrically(Joint& joint, const ElectricActuator& actuator, const RotaryLoads& loads) {
  const plant::ElectricParams params = electric_params(actuator);
  joint.rotary = true;
  joint.electric = params;
  joint.actuator = limits_of_electric(params);
  joint.swing_load = rotary_load(loads.swing);
  joint.stance_load = rotary_load(loads.stance);
  const double rated = rated_torque_Nm(actuator);
  const RotaryNoise noise = actuator.noise.value_or(RotaryNoise{1e-5, 2e-3, 1e-3 * rated});
  joint.noise = {noise.position_rad, noise.velocity_rad_s, noise.torque_Nm};
  joint.normalisation = {0.5 * params.travel, actuator.velocity_norm_rad_s.value_or(plant::no_load_speed(params)),
                         actuator.torque_norm_Nm.value_or(rated), plant::current_max_A(params)};
  joint.push_limit = joint.pull_limit = std::min(rated, plant::stall_torque(params));
}

}  // namespace farrier::robot
