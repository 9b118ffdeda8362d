#include "locomotion/trunk_wrench.hpp"

#include <algorithm>

#include "locomotion/rotation.hpp"

namespace farrier::locomotion {

void TrunkWrench::reset_integrals() noexcept {
  height_integral_m_s2_ = 0.0;
  tilt_integral_Nm_.setZero();
}

Wrench TrunkWrench::step(const TrunkState& wanted, const TrunkState& is, double share) noexcept {
  const Eigen::Vector3d error = wanted.position_m - is.position_m;
  const Eigen::Matrix3d to_trunk = is.rotation.transpose();
  const Eigen::Vector3d turn = to_trunk * sine_vector(wanted.rotation * to_trunk);
  const Eigen::Vector3d rate = to_trunk * (wanted.angular_velocity_rad_s - is.angular_velocity_rad_s);
  if (share >= 1.0) {
    height_integral_m_s2_ = std::clamp(height_integral_m_s2_ + period_s_ * params_.height_integral_1_s3 * error.z(),
                                       -params_.height_integral_limit_m_s2, params_.height_integral_limit_m_s2);
    const Eigen::Vector3d slope = params_.tilt_integral_1_s * params_.attitude_gain_Nm_rad.cwiseProduct(turn);
    const Eigen::Vector3d limit{params_.tilt_integral_limit_Nm, params_.tilt_integral_limit_Nm, 0.0};
    tilt_integral_Nm_ = (tilt_integral_Nm_ + period_s_ * slope).cwiseMax(-limit).cwiseMin(limit);
  }
  Eigen::Vector3d acceleration = params_.position_gain_1_s2.cwiseProduct(error) +
                                 params_.velocity_gain_1_s.cwiseProduct(wanted.velocity_m_s - is.velocity_m_s);
  acceleration.z() += kGravity_m_s2 + height_integral_m_s2_;
  const Eigen::Vector3d moment = params_.attitude_gain_Nm_rad.cwiseProduct(turn) +
                                 params_.rate_gain_Nms_rad.cwiseProduct(rate) + tilt_integral_Nm_;
  Wrench wrench;
  wrench << mass_kg_ * acceleration, is.rotation * moment;
  return share * wrench;
}

}  // namespace farrier::locomotion
