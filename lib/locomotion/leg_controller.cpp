#include "locomotion/leg_controller.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace farrier::locomotion {
Eigen::Vector3d LegController::stance(const LegState& leg, const Eigen::Vector3d& force_N) const noexcept {
  return leg.bias_torque_Nm - leg.jacobian.transpose() * force_N;
}

Eigen::Vector3d LegController::swing(const LegState& leg, const FootReference& foot,
                                     Eigen::Vector3d& acceleration_rad_s2) const noexcept {
  Eigen::Matrix3d inverse;
  bool invertible = false;
  leg.jacobian.computeInverseWithCheck(inverse, invertible, kSingularLeg_m3);
  acceleration_rad_s2.setZero();
  if (invertible) {
    acceleration_rad_s2 = inverse * (foot.acceleration_m_s2 - leg.foot_bias_m_s2);
  }
  const Eigen::Vector3d force = params_.swing_stiffness_N_m.cwiseProduct(foot.position_m - leg.foot_m) +
                                params_.swing_damping_Ns_m.cwiseProduct(foot.velocity_m_s - leg.foot_velocity_m_s);
  return leg.bias_torque_Nm + leg.inertia_kg_m2 * acceleration_rad_s2 + leg.jacobian.transpose() * force;
}

Eigen::Vector3d LegController::pose(const LegReadings& leg, const Eigen::Vector3d& wanted_rad,
                                    double gain) const noexcept {
  return gain * (params_.pose_stiffness_Nm_rad.cwiseProduct(wanted_rad - leg.position_rad) -
                 params_.pose_damping_Nms_rad.cwiseProduct(leg.velocity_rad_s));
}

Eigen::Vector3d LegController::damp(const LegReadings& leg) const noexcept {
  return -params_.stop_damping_Nms_rad.cwiseProduct(leg.velocity_rad_s);
}

Eigen::Vector3d LegController::limited(const Eigen::Vector3d& torque_Nm) const noexcept {
  Eigen::Vector3d torque;
  for (int i = 0; i < kJointsPerLeg; ++i) {
    const double limit = params_.torque_limit_Nm[i];
    torque[i] = std::isnan(torque_Nm[i]) ? 0.0 : std::clamp(torque_Nm[i], -limit, limit);
  }
  return torque;
}

Eigen::Vector3d LegController::within_reach(const Eigen::Vector3d& hip_m,
                                            const Eigen::Vector3d& foot_m) const noexcept {
  const Eigen::Vector3d leg = foot_m - hip_m;
  const double length = leg.norm();
  return length > params_.longest_leg_m ? Eigen::Vector3d(hip_m + params_.longest_leg_m / length * leg) : foot_m;
}

double LegController::largest_force_N(const LegState& leg, const Eigen::Vector3d& normal) const noexcept {
  const Eigen::Vector3d lever = leg.jacobian.transpose() * normal;  // torque per newton
  double force = std::numeric_limits<double>::max();
  for (int i = 0; i < kJointsPerLeg; ++i) {
    if (std::abs(lever[i]) > 0.0) {
      force = std::min(force, params_.torque_limit_Nm[i] / std::abs(lever[i]));
    }
  }
  return force;
}

}  // namespace farrier::locomotion
