#include "plant/load_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "core/ensure.hpp"

namespace farrier::plant {

LoadPressureCoefficients load_pressure_coefficients(const ActuatorParams& actuator, const OperatingPoint& point,
                                                    Volumes volumes) {
  FARRIER_ENSURE(point.valve_sign != 0.0, "the rate of the load pressure needs the sign of the valve current");
  const double sign = point.valve_sign > 0.0 ? 1.0 : -1.0;
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

  const double drop = sign > 0.0 ? p_s - p_l - alpha * p_t : alpha * p_s + p_l - p_t;

  const double valve = actuator.valve_gain / std::sqrt(1.0 + alpha3);
  const double opening = valve * std::abs(point.valve_current_A);
  const double compliance = beta_e / V_a + alpha2 * beta_e / V_b;
  const double volume_slope =
      volumes == Volumes::kConstant ? 0.0 : beta_e * A_p / (V_a * V_a) - alpha3 * beta_e * A_p / (V_b * V_b);
  LoadPressureCoefficients of;
  of.sign = sign;
  of.root = std::sqrt(std::max(drop, actuator.laminar_pressure_Pa));
  of.K_pl = -0.5 * opening * compliance;  // (3.29)
  of.K_xpA = opening * volume_slope;      // (3.30)
  of.K_xpB = A_p * volume_slope;          // (3.31)
  of.K_vp = -A_p * compliance;            // (3.32)
  of.K_uv = valve * compliance;           // (3.33)
  of.velocity = point.velocity;
  return of;
}

State steady_chambers(const ActuatorParams& actuator, const OperatingPoint& point) noexcept {
  const double alpha = actuator.area_b / actuator.area_a;
  const double alpha2 = alpha * alpha;
  // Pressures of the ports of chambers a and b: supply and return for u > 0, the other way for u < 0.
  const double lean = point.valve_sign > 0.0 ? 1.0 : point.valve_sign < 0.0 ? 0.0 : 0.5;
  const double port_a = lean * actuator.supply_pressure_Pa + (1.0 - lean) * actuator.return_pressure_Pa;
  const double port_b = (1.0 - lean) * actuator.supply_pressure_Pa + lean * actuator.return_pressure_Pa;
  // (3.19)
  const double p_b = (alpha2 * (port_a - point.load_pressure_Pa) + port_b) / (1.0 + alpha2 * alpha);
  return {point.position, point.velocity, point.load_pressure_Pa + alpha * p_b, p_b};
}

double leakage_pressure_Pa(const ActuatorParams& actuator, const OperatingPoint& point) noexcept {
  const double alpha = actuator.area_b / actuator.area_a;
  const double by_a = 1.0 / (actuator.line_volume_m3 + point.position * actuator.area_a);
  const double by_b = alpha / (actuator.line_volume_m3 + (actuator.stroke - point.position) * actuator.area_b);
  const State chambers = steady_chambers(actuator, point);
  return (chambers.pressure_a_Pa - chambers.pressure_b_Pa) * (by_a + by_b) / (by_a + alpha * by_b);
}

}  // namespace farrier::plant
