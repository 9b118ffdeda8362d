#include "plant/nominal.hpp"

namespace farrier::plant {

ActuatorParams nominal_cylinder() {
  ActuatorParams cylinder;
  cylinder.area_a = 2.0106e-4;
  cylinder.area_b = 1.2252e-4;
  cylinder.stroke = 0.08;
  cylinder.line_volume_m3 = 3.4023e-6;
  cylinder.bulk_modulus_Pa = 1.3e9;
  cylinder.valve_gain = 6.6815e-6;
  cylinder.valve_current_max_A = kNominalCurrent_A;
  cylinder.supply_pressure_Pa = 250e5;
  cylinder.return_pressure_Pa = 0.0;
  cylinder.piston_mass = 0.3141;
  cylinder.piston_damping = 700.0;
  cylinder.stop_stiffness = 2e7;
  cylinder.stop_damping = 1e4;
  return cylinder;
}

LoadParams nominal_load() { return {10.0, 700.0, 2.0 * 10740.0, 0.04}; }

Eigen::Vector4d nominal_state_divisors(const ActuatorParams& actuator) {
  return {0.5 * actuator.stroke, kNominalVelocity_m_s, actuator.supply_pressure_Pa, actuator.supply_pressure_Pa};
}

OperatingPoint nominal_point(double valve_sign) { return {0.04, 0.0, 0.0, 0.0, valve_sign}; }

ChamberPoint nominal_chamber_point(double valve_sign) {
  const ActuatorParams cylinder = nominal_cylinder();
  const double alpha = cylinder.area_b / cylinder.area_a;
  const double p_b = cylinder.supply_pressure_Pa / (1.0 + alpha);
  return {{0.04, 0.0, alpha * p_b, p_b}, 0.0, valve_sign};
}

}  // namespace farrier::plant
