#include "plant/electric_actuator.hpp"

#include "plant/refusals.hpp"

namespace farrier::plant {

// The names are those of the keys in a robot file.
Result<Done> validate(const ElectricParams& a) {
  Refusals refusals("electric actuator");
  refusals.positive("torque_constant_Nm_A", a.torque_constant_Nm_A);
  refusals.positive("winding_resistance_Ohm", a.winding_resistance_Ohm);
  refusals.positive("supply_voltage_V", a.supply_voltage_V);
  refusals.positive("gear_ratio", a.gear_ratio);
  refusals.not_negative("damping_Nms_rad", a.damping);
  refusals.not_negative("coulomb_Nm", a.coulomb);
  refusals.positive("slip_velocity_rad_s", a.slip_velocity);
  if (a.rigid) {
    refusals.not_negative("rotor_inertia_kg_m2", a.rotor_inertia_kg_m2);
    refusals.positive("torque_time_constant_s", a.torque_time_constant_s);
    refusals.require(a.current_limit_A > 0.0, "current_limit_A", current_max_A(a), "> 0");
  } else {
    refusals.positive("rotor_inertia_kg_m2", a.rotor_inertia_kg_m2);
    refusals.positive("winding_inductance_H", a.winding_inductance_H);
    refusals.not_negative("spring_damping_Nms_rad", a.spring_damping);
    // Roots of J N^2 s^2 + D s + k: real, or the rotor swings on its spring and (x, v, T) do not hold the joint.
    refusals.require(a.spring_stiffness > 0.0 && a.spring_stiffness <= stiffest_spring_Nm_rad(a),
                     "spring_stiffness_Nm_rad", a.spring_stiffness,
                     "above 0 and at most " + number_text(stiffest_spring_Nm_rad(a)));
  }
  refusals.positive("travel_rad", a.travel);
  const double least_stop = 100.0 * stall_torque(a) / a.travel;
  refusals.require(a.stop_stiffness >= least_stop, "stops.stiffness_Nm_rad", a.stop_stiffness,
                   "at least " + number_text(least_stop) + ", so that the stalled motor presses in 1 % of the travel");
  refusals.not_negative("stops.damping_Nms_rad", a.stop_damping);
  return refusals.verdict();
}

Result<Done> validate(const ElectricParams& actuator, const ElectricState& state) {
  Refusals refusals("initial state");
  refusals.require(state.position >= 0.0 && state.position <= actuator.travel, "position", state.position,
                   "within [0, travel]");
  refusals.require(true, "velocity", state.velocity, "finite");
  refusals.require(true, "deflection", state.deflection, "finite");
  refusals.require(true, "rotor", state.rotor, "finite");
  refusals.require(true, "current_A", state.current_A, "finite");
  return refusals.verdict();
}

ElectricState equilibrium(const ElectricParams& a, const LoadParams& load, double position, double external_force) {
  const double torque = load.stiffness * (position - load.equilibrium_position) - external_force;
  return {.position = position,
          .velocity = 0.0,
          .deflection = a.rigid ? 0.0 : torque / a.spring_stiffness,
          .rotor = 0.0,
          .current_A = torque / (a.gear_ratio * a.torque_constant_Nm_A)};
}

LinearModel linearise_load_cell_force(const ElectricParams& a, const LoadParams& load) {
  if (a.rigid) {
    const double mass = load.mass + armature_kg_m2(a);
    const double rate_1_s = 1.0 / a.torque_time_constant_s;
    LinearModel rigid;
    rigid.a << 0.0, 1.0, 0.0,                                                    //
        -load.stiffness / mass, -(load.damping + a.damping) / mass, 1.0 / mass,  //
        0.0, 0.0, -rate_1_s;
    rigid.b << 0.0, 0.0, rate_1_s * a.gear_ratio * a.torque_constant_Nm_A;
    return rigid;
  }
  const double D = rotor_damping(a);
  const double k = a.spring_stiffness;
  const double b = a.spring_damping;
  const double C = load.stiffness;
  const double d_l = load.damping;
  const double m_l = load.mass;
  const double share = 1.0 / (1.0 + b / D);
  LinearModel model;
  model.a << 0.0, 1.0, 0.0,             //
      -C / m_l, -d_l / m_l, 1.0 / m_l,  //
      share * b * C / m_l, share * (b * d_l / m_l - k), -share * (k / D + b / m_l);
  model.b << 0.0, 0.0, share * k * a.gear_ratio * a.torque_constant_Nm_A / D;
  return model;
}

StateSpace<5> linearise_full(const ElectricParams& a, const LoadParams& load, double rotor) {
  const double NK = a.gear_ratio * a.torque_constant_Nm_A;
  const double inertia = armature_kg_m2(a);
  const double k = a.spring_stiffness;
  const double b = a.spring_damping;
  const double m_l = load.mass;
  // d phi / d w = w_s^2 / (w^2 + w_s^2)^(3/2)
  const double square = rotor * rotor + a.slip_velocity * a.slip_velocity;
  const double dry = a.coulomb * a.slip_velocity * a.slip_velocity / (square * std::sqrt(square));
  StateSpace<5> model;
  model.a << 0.0, 1.0, 0.0, 0.0, 0.0,                                           //
      -load.stiffness / m_l, -(load.damping + b) / m_l, k / m_l, b / m_l, 0.0,  //
      0.0, -1.0, 0.0, 1.0, 0.0,                                                 //
      0.0, b / inertia, -k / inertia, -(a.damping + dry + b) / inertia, NK / inertia, 0.0, 0.0, 0.0,
      -NK / a.winding_inductance_H, -a.winding_resistance_Ohm / a.winding_inductance_H;
  model.b << 0.0, 0.0, 0.0, 0.0, a.winding_resistance_Ohm / a.winding_inductance_H;
  return model;
}

}  // namespace farrier::plant
