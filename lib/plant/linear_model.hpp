#pragma once

#include <Eigen/Core>

#include "plant/actuator.hpp"

namespace farrier::plant {

/// Continuous linear model around an operating point, deviations in SI:
/// states (position m|rad, velocity m/s|rad/s, load-cell force N|Nm), input valve current A.
struct LinearModel {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
};

struct OperatingPoint {
  double position = 0.0;          ///< m or rad
  double velocity = 0.0;          ///< m/s or rad/s
  double load_pressure_Pa = 0.0;  ///< p_l = p_a - alpha p_b
  double valve_current_A = 0.0;   ///< only its size counts
  double valve_sign = 0.0;        ///< +1, -1, or 0 for the mean of both signs
};

/// Model in the load-cell force, Hubacher (2014) (3.43)-(3.51), with row 2 of (3.51a) set right:
/// [-C/m_l, -d_l/m_l, 1/m_l] from (3.47). Assumes steady chamber pressures (3.19), (3.20) and m_p << m_l.
/// Needs m_l > 0. The roots of the pressure drops are taken no smaller than at the laminar pressure.
LinearModel linearise_load_cell_force(const ActuatorParams& actuator, const LoadParams& load,
                                      const OperatingPoint& point);

}  // namespace farrier::plant
