#pragma once

#include "plant/actuator.hpp"

namespace farrier::plant {

/// Coefficients of the hydraulic force's rate, F_h' = K_th (q_e - A_e v): Hubacher (2014) (2.33)-(2.39).
struct TransmissionStiffness {
  double K_tha;  ///< A_p beta_e / V_a, Pa/m | Pa/rad (2.34)
  double K_thb;  ///< alpha A_p beta_e / V_b (2.35)
  double K_th;   ///< of both chambers (2.36)
  double q_e;    ///< equivalent flow, m^3/s (2.37)
  double A_e;    ///< equivalent area, m^2 | m^3/rad (2.38)
};

/// The three different forces of Hubacher (2014), Chapter 2, and their rates. N and N/s, or Nm and Nm/s.
struct Forces {
  double hydraulic;        ///< F_h (2.8)
  double total;            ///< F_t = (m_l + m_p) a (2.40), (2.41) with B y' where B y'' is printed
  double load_cell;        ///< F_s = F_h - d_p v - m_p a (2.22)
  double hydraulic_rate;   ///< (2.39)
  double total_rate;       ///< (2.42)
  double load_cell_rate;   ///< (2.43) solved for F_s', with m_p x''' where m_p x'' is printed
};

/// At a state inside the stroke whose chambers are full of oil (pressures > 0), with the valve current held; beyond the
/// stroke and in voids other terms act. Current within +-valve_current_max_A. Non-finite arguments give non-finite
/// values.
TransmissionStiffness transmission_stiffness(const ActuatorParams& actuator, const State& state,
                                             double valve_current_A) noexcept;

/// Same conditions; `external_force` (N or Nm, positive along +position) is on the load and held. Needs m_l + m_p > 0.
Forces forces(const ActuatorParams& actuator, const LoadParams& load, const State& state, double valve_current_A,
              double external_force) noexcept;

}  // namespace farrier::plant
