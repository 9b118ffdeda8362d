#include "plant/force_dynamics.hpp"

#include <cmath>

#include "plant/oil.hpp"

namespace farrier::plant {

TransmissionStiffness transmission_stiffness(const ActuatorParams& actuator, const State& state,
                                             double valve_current_A) noexcept {
  const double A_p = actuator.area_a;
  const double alpha = actuator.area_b / actuator.area_a;
  const auto [V_a, V_b] = chamber_volumes(actuator, state.position);

  // (2.14), (2.15): q_a into chamber a, q_b out of chamber b; the ports carry the sign of u.
  const auto [port_a, port_b] =
      port_pressures(valve_current_A > 0.0, actuator.supply_pressure_Pa, actuator.return_pressure_Pa);
  const double flow_gain = actuator.valve_gain * std::abs(valve_current_A);
  const double q_a = flow_gain * orifice_root(port_a - state.pressure_a_Pa, actuator.laminar_pressure_Pa);
  const double q_b = flow_gain * orifice_root(state.pressure_b_Pa - port_b, actuator.laminar_pressure_Pa);

  TransmissionStiffness of;
  of.K_tha = A_p * actuator.bulk_modulus_Pa / V_a;                   // (2.34)
  of.K_thb = alpha * A_p * actuator.bulk_modulus_Pa / V_b;           // (2.35)
  of.K_th = of.K_tha + of.K_thb;                                     // (2.36)
  of.q_e = (V_b * q_a + alpha * V_a * q_b) / (V_b + alpha * V_a);    // (2.37)
  of.A_e = A_p * (V_b + alpha * alpha * V_a) / (V_b + alpha * V_a);  // (2.38)
  return of;
}

Forces forces(const ActuatorParams& actuator, const LoadParams& load, const State& state, double valve_current_A,
              double external_force) noexcept {
  const TransmissionStiffness drive = transmission_stiffness(actuator, state, valve_current_A);
  const double M = load.mass + actuator.piston_mass;        // (2.25)
  const double B = load.damping + actuator.piston_damping;  // (2.26)
  const double C = load.stiffness;                          // (2.27)
  const double v = state.velocity;

  Forces of;
  of.hydraulic = hydraulic_force(actuator, state.pressure_a_Pa, state.pressure_b_Pa);
  // (2.41) and what acts on the load from outside
  of.total = of.hydraulic - B * v - C * (state.position - load.equilibrium_position) + external_force;
  const double acceleration = of.total / M;                                                         // (2.40)
  of.load_cell = of.hydraulic - actuator.piston_damping * v - actuator.piston_mass * acceleration;  // (2.22)

  of.hydraulic_rate = drive.K_th * (drive.q_e - drive.A_e * v);  // (2.39)
  of.total_rate = of.hydraulic_rate - B * acceleration - C * v;  // (2.42)
  const double jerk = of.total_rate / M;
  // (2.43): F_t' = F_s' - C v - d_l a + m_p x'''
  of.load_cell_rate = of.total_rate + C * v + load.damping * acceleration - actuator.piston_mass * jerk;
  return of;
}

}  // namespace farrier::plant
