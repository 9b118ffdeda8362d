#include "plant/linear_model.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::plant {
namespace {

LinearModel linearise_for_sign(const ActuatorParams& actuator, const LoadParams& load, const OperatingPoint& point,
                               double sign) {
  const double A_p = actuator.area_a;
  const double alpha = actuator.area_b / actuator.area_a;
  const double alpha2 = alpha * alpha;
  const double alpha3 = alpha2 * alpha;
  const double beta_e = actuator.bulk_modulus_Pa;
  const double p_s = actuator.supply_pressure_Pa;
  const double p_t = actuator.return_pressure_Pa;
  const double p_l = point.load_pressure_Pa;

  // (3.27), (3.28)
  const double V_a = actuator.line_volume_m3 + point.position * A_p;
  const double V_b = actuator.line_volume_m3 + (actuator.stroke - point.position) * alpha * A_p;

  // sqrt(p_s - p_l - alpha p_t) for u > 0, sqrt(alpha p_s + p_l - p_t) for u < 0
  const double drop = sign > 0.0 ? p_s - p_l - alpha * p_t : alpha * p_s + p_l - p_t;
  const double root = std::sqrt(std::max(drop, actuator.laminar_pressure_Pa));

  const double valve = actuator.valve_gain / std::sqrt(1.0 + alpha3);
  const double opening = valve * std::abs(point.valve_current_A);
  const double compliance = beta_e / V_a + alpha2 * beta_e / V_b;
  const double volume_slope = beta_e * A_p / (V_a * V_a) - alpha3 * beta_e * A_p / (V_b * V_b);
  const double K_pl = -0.5 * opening * compliance;  // (3.29)
  const double K_xpA = opening * volume_slope;      // (3.30)
  const double K_xpB = A_p * volume_slope;          // (3.31)
  const double K_vp = -A_p * compliance;            // (3.32)
  const double K_uv = valve * compliance;           // (3.33)

  const double G_Fs = K_pl / root;                                         // (3.43)
  const double G_xp = A_p * (-sign * K_xpA * root + K_xpB * point.velocity);  // (3.44)
  const double G_uv = A_p * K_uv * root;                                   // (3.45)

  const double C = load.stiffness;
  const double d_l = load.damping;
  const double m_l = load.mass;
  const double d_p = actuator.piston_damping;
  LinearModel model;
  model.a << 0.0, 1.0, 0.0,                    //
      -C / m_l, -d_l / m_l, 1.0 / m_l,         // (3.47)
      G_xp + d_p * C / m_l, G_Fs * d_p + d_p * d_l / m_l + A_p * K_vp, G_Fs - d_p / m_l;  // (3.48)
  model.b << 0.0, 0.0, G_uv;
  return model;
}

}  // namespace

LinearModel linearise_load_cell_force(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point) {
  if (point.valve_sign != 0.0) {
    return linearise_for_sign(actuator, load, point, point.valve_sign > 0.0 ? 1.0 : -1.0);
  }
  const LinearModel extending = linearise_for_sign(actuator, load, point, 1.0);
  const LinearModel retracting = linearise_for_sign(actuator, load, point, -1.0);
  return {0.5 * (extending.a + retracting.a), 0.5 * (extending.b + retracting.b)};
}

}  // namespace farrier::plant
